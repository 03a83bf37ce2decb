open Scc_exact

type t = { formula : Formula.t; position : Positions.position; holds : bool; because : because }

and because =
  | Given
  | Parts of t list
  | Run of { run : Run.t; parts : t list }
  | Everywhere of int

let definitely e f position wanted =
  match Eval.truth e f position with Some v -> Bool.equal v wanted | None -> false

(* The nodes on the way of "f until g": what is gone through before g, as far as it may be of use. *)
let count e (u : Eval.until) position =
  let f = (Eval.value e u.left).upper and g = (Eval.value e u.right).lower in
  let n = ref 0 in
  let passes (p : Positions.position) =
    let f = Positions.along f p.node and g = Positions.along g p.node in
    match if Positions.is_inside p then Flow.from ~f ~g p.offset else Flow.entering ~f ~g with
    | Passes -> true
    | Reached _ | Lost _ -> Rat.sign u.bound.low > 0
  in
  let through s = Positions.at f s && (Rat.sign u.bound.low > 0 || not (Positions.at g s)) in
  Reach.visit (Eval.graph e) ?within:u.bound.high [ position ] ~through ~passes (fun _ -> incr n);
  !n

(* [right] is what the right side is about: f for G f, which is read as "not F not f". *)
let until e (u : Eval.until) ~right position holds explain =
  let at_goal run side formula wanted =
    match Run.goal run with
    | Some goal when definitely e side goal wanted -> [ explain formula goal ]
    | Some _ | None -> []
  in
  match (u.quantifier, holds) with
  | Exists, true ->
    let run = Deciding_run.some e u position in
    Run { run; parts = at_goal run u.right right true }
  | All, false ->
    let run = Deciding_run.every e u position in
    Run { run; parts = at_goal run u.left u.left false @ at_goal run u.right right false }
  | Exists, false | All, true -> Everywhere (count e u position)

let visited e position =
  let n = ref 0 in
  Reach.visit (Eval.graph e) [ position ] ~through:(fun _ -> true) ~passes:(fun _ -> true) (fun _ ->
      incr n);
  !n

let next e (f : Formula.t) position holds ~quantifier explain =
  match ((quantifier : Formula.quantifier), holds) with
  | Exists, true | All, false ->
    let value = Eval.value e f and reach = Eval.value e (Next (quantifier, f)) in
    let is_so s = if holds then Positions.at value.lower s else not (Positions.at value.upper s) in
    let leads s = if holds then Positions.at reach.lower s else not (Positions.at reach.upper s) in
    let run = Deciding_run.next e ~holds:is_so ~leads position in
    Run { run; parts = [ explain f (Positions.start run.last) ] }
  | Exists, false | All, true -> Everywhere (visited e position)

(* Recursion is as deep as the formula. *)
let rec of_known e (formula : Formula.t) position : t =
  match Eval.truth e formula position with
  | None -> Scc_base.Bug.fail __POS__ "what is not decided is explained"
  | Some holds ->
    let explain = of_known e in
    let deciding fs = List.filter (fun f -> definitely e f position holds) fs in
    let first fs = match deciding fs with [] -> [] | f :: _ -> [ explain f position ] in
    let all fs = List.map (fun f -> explain f position) fs in
    let because =
      match formula with
      | Predicate _ -> Given
      | Not f -> Parts [ explain f position ]
      | And fs -> Parts (if holds then all fs else first fs)
      | Or fs -> Parts (if holds then first fs else all fs)
      | Next (quantifier, f) -> next e f position holds ~quantifier explain
      | Until _ | Finally _ | Globally _ -> (
          match Eval.as_until formula with
          | None -> Scc_base.Bug.fail __POS__ "an operator of time that is none"
          | Some (u, flipped) ->
            let right = match formula with Globally (_, _, f) -> f | _ -> u.right in
            until e u ~right position (not (Bool.equal holds flipped)) explain)
    in
    { formula; position; holds; because }

let explain e f position =
  match Eval.truth e f position with None -> None | Some _ -> Some (of_known e f position)

let goes_on (run : Run.t) =
  match (run.steps, Run.goal run) with
  | [], None -> not (Positions.is_inside run.start)
  | _ -> true

let rec chain t =
  match t.because with
  | Given | Everywhere _ -> None
  | Parts parts -> List.find_map chain parts
  | Run { run; parts } -> (
      match (Run.goal run, List.find_map chain parts) with
      | Some _, Some more when goes_on more -> Some (Run.append run more)
      | _ -> Some run)
