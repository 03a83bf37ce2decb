open Scc_exact

type t = { formula : Ctl_formula.t; position : Ctl_set.position; holds : bool; because : because }

and because =
  | Given
  | Parts of t list
  | Run of { run : Ctl_run.t; parts : t list }
  | Everywhere of int

let definitely e f position wanted =
  match Ctl_eval.truth e f position with Some v -> Bool.equal v wanted | None -> false

(* The nodes on the way of "f until g": what is gone through before g, as far as it may be of use. *)
let count e (u : Ctl_eval.until) position =
  let f = (Ctl_eval.value e u.left).upper and g = (Ctl_eval.value e u.right).lower in
  let n = ref 0 in
  let passes (p : Ctl_set.position) =
    let f = Ctl_set.along f p.node and g = Ctl_set.along g p.node in
    match if Ctl_set.is_inside p then Ctl_flow.from ~f ~g p.offset else Ctl_flow.entering ~f ~g with
    | Passes -> true
    | Reached _ | Lost _ -> Rat.sign u.bound.low > 0
  in
  let through s = Ctl_set.at f s && (Rat.sign u.bound.low > 0 || not (Ctl_set.at g s)) in
  Ctl_reach.visit (Ctl_eval.graph e) ?within:u.bound.high [ position ] ~through ~passes (fun _ -> incr n);
  !n

(* [right] is what the right side is about: f for G f, which is read as "not F not f". *)
let until e (u : Ctl_eval.until) ~right position holds explain =
  let at_goal run side formula wanted =
    match Ctl_run.goal run with
    | Some goal when definitely e side goal wanted -> [ explain formula goal ]
    | Some _ | None -> []
  in
  match (u.quantifier, holds) with
  | Exists, true ->
    let run = Ctl_witness.some e u position in
    Run { run; parts = at_goal run u.right right true }
  | All, false ->
    let run = Ctl_witness.every e u position in
    Run { run; parts = at_goal run u.left u.left false @ at_goal run u.right right false }
  | Exists, false | All, true -> Everywhere (count e u position)

let visited e position =
  let n = ref 0 in
  Ctl_reach.visit (Ctl_eval.graph e) [ position ] ~through:(fun _ -> true) ~passes:(fun _ -> true) (fun _ ->
      incr n);
  !n

let next e (f : Ctl_formula.t) position holds ~quantifier explain =
  match ((quantifier : Scc_property.Property.path_quantifier), holds) with
  | Exists, true | All, false ->
    let value = Ctl_eval.value e f and reach = Ctl_eval.value e (Next (quantifier, f)) in
    let is_so s = if holds then Ctl_set.at value.lower s else not (Ctl_set.at value.upper s) in
    let leads s = if holds then Ctl_set.at reach.lower s else not (Ctl_set.at reach.upper s) in
    let run = Ctl_witness.next e ~holds:is_so ~leads position in
    Run { run; parts = [ explain f (Ctl_set.start run.last) ] }
  | Exists, false | All, true -> Everywhere (visited e position)

(* Recursion is as deep as the formula. *)
let rec of_known e (formula : Ctl_formula.t) position : t =
  match Ctl_eval.truth e formula position with
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
          match Ctl_eval.as_until formula with
          | None -> Scc_base.Bug.fail __POS__ "an operator of time that is none"
          | Some (u, flipped) ->
            let right = match formula with Globally (_, _, f) -> f | _ -> u.right in
            until e u ~right position (not (Bool.equal holds flipped)) explain)
    in
    { formula; position; holds; because }

let explain e f position =
  match Ctl_eval.truth e f position with None -> None | Some _ -> Some (of_known e f position)

let goes_on (run : Ctl_run.t) =
  match (run.steps, Ctl_run.goal run) with
  | [], None -> not (Ctl_set.is_inside run.start)
  | _ -> true

let rec chain t =
  match t.because with
  | Given | Everywhere _ -> None
  | Parts parts -> List.find_map chain parts
  | Run { run; parts } -> (
      match (Ctl_run.goal run, List.find_map chain parts) with
      | Some _, Some more when goes_on more -> Some (Ctl_run.append run more)
      | _ -> Some run)
