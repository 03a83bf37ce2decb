open Scc_base
open Scc_exact

type t = { formula : Timed_formula.t; position : Positions.position; holds : bool; because : because }

and because =
  | Given
  | Parts of t list
  | Run of { run : Run.t; way : way; parts : t list; along : along option }
  | Everywhere of int Lazy.t
  | Likelihood of {
      side : Timed_formula.side;
      measured : Eval.measured;
      run : (Run.t * Rat.t) option;
      parts : t list;
    }

and way = Own | Onward of Course.place option
and along = { claim : Timed_formula.t; claimed : bool; course : Course.t; stretches : stretch list }
and stretch = { place : Course.place; why : t Lazy.t }

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
  Reachable.visit (Eval.graph e) ?within:u.bound.high [ position ] ~through ~passes (fun _ -> incr n);
  !n

(* What is claimed of the positions on the way of a run: at each it is explained by itself, if need be by how the
   run itself goes on. *)
let on_the_way e formula holds bound run explain =
  match (formula : Timed_formula.t) with
  | And [] -> None
  | _ ->
    let course = Course.make e [ formula ] run in
    (* Where an open interval begins on which f fails, g may hold: "f until g" does not any more. *)
    let is_so index = definitely e formula course.places.(index).position holds in
    let stretch index =
      let place = course.places.(index) in
      let spot = { Course.course; index; at = place.position } in
      { place; why = lazy (explain (Some spot) formula place.position) }
    in
    let stretches = List.map stretch (List.filter is_so (Course.within course bound)) in
    Some { claim = formula; claimed = holds; course; stretches }

let always = { Timed_formula.low = Rat.zero; high = None }

(* [right] is what the right side is about: f for G f, which is read as "not F not f". *)
let until e (u : Eval.until) ~right spot position holds explain =
  let found () =
    match Option.bind spot (Course.follow e u) with
    | Some (run, there) ->
      let place (s : Course.spot) = s.course.places.(s.index) in
      (run, Onward (Option.map place there), there)
    | None -> ((if holds then Deciding_run.some else Deciding_run.every) e u position, Own, None)
  in
  let at_goal (run, _, there) side formula wanted =
    match Run.goal run with
    | Some goal when definitely e side goal wanted -> [ explain there formula goal ]
    | Some _ | None -> []
  in
  match (u.quantifier, holds) with
  | Exists, true ->
    let (run, way, _) as found = found () in
    let along = on_the_way e u.claim true always run explain in
    Run { run; way; parts = at_goal found u.right right true; along }
  | All, false ->
    let (run, way, _) as found = found () in
    let along = on_the_way e right (not (right == u.right)) u.bound run explain in
    let parts = at_goal found u.claim u.claim false @ at_goal found u.right right false in
    Run { run; way; parts; along }
  | Exists, false | All, true -> Everywhere (lazy (count e u position))
  | Chance _, _ -> Bug.fail __POS__ "a probability is explained by one run"

(* Of F and U a run that does as they say, of G one that does not. *)
let likelihood e formula (u : Eval.until) ~side position explain =
  let measured = Eval.probability e ~decide:false side formula position in
  let run = Eval.likely_run e u position in
  let at_goal =
    match Option.bind run (fun (run, _) -> Run.goal run) with
    | Some goal when definitely e u.right goal true -> [ explain None u.right goal ]
    | Some _ | None -> []
  in
  Likelihood { side; measured; run; parts = at_goal }

let visited e position =
  let n = ref 0 in
  Reachable.visit (Eval.graph e) [ position ] ~through:(fun _ -> true) ~passes:(fun _ -> true) (fun _ ->
      incr n);
  !n

let next e (f : Timed_formula.t) position holds ~quantifier explain =
  match ((quantifier : Timed_formula.quantifier), holds) with
  | Exists, true | All, false ->
    let value = Eval.value e f and reach = Eval.value e (Next (quantifier, f)) in
    let is_so s = if holds then Positions.at value.lower s else not (Positions.at value.upper s) in
    let leads s = if holds then Positions.at reach.lower s else not (Positions.at reach.upper s) in
    let run = Deciding_run.next e ~holds:is_so ~leads position in
    Run { run; way = Own; parts = [ explain f (Positions.start run.last) ]; along = None }
  | Exists, false | All, true | Chance _, _ -> Everywhere (lazy (visited e position))

exception Not_known

(* Recursion is as deep as the formula. What was known once may need more effort now than is left. *)
let rec of_known e spot (formula : Timed_formula.t) position : t =
  match Eval.truth e formula position with
  | None -> raise Not_known
  | Some holds ->
    let explain = of_known e spot in
    let deciding fs = List.filter (fun f -> definitely e f position holds) fs in
    let first fs = match deciding fs with [] -> [] | f :: _ -> [ explain f position ] in
    let all fs = List.map (fun f -> explain f position) fs in
    let because =
      match formula with
      | Predicate _ -> Given
      | Not f -> Parts [ explain f position ]
      | And fs -> Parts (if holds then all fs else first fs)
      | Or fs -> Parts (if holds then first fs else all fs)
      | Next (quantifier, f) -> next e f position holds ~quantifier (of_known e None)
      | Until _ | Finally _ | Globally _ -> (
          match Eval.as_until e formula with
          | None -> Bug.fail __POS__ "an operator of time that is none"
          | Some (({ quantifier = Chance { side; _ }; _ } as u), flipped) ->
            let side = if flipped then Timed_formula.other_side side else side in
            likelihood e formula u ~side position (of_known e)
          | Some (u, flipped) ->
            let right = match formula with Globally (_, _, f) -> f | _ -> u.right in
            until e u ~right spot position (not (Bool.equal holds flipped)) (of_known e))
    in
    { formula; position; holds; because }

let explain e f position = of_known e None f position

let goes_on (run : Run.t) =
  match (run.steps, run.finish) with
  | [], Passes left when Algebraic.compare left run.start.offset > 0 -> true
  | [], (Rests | Stops | Repeats _ | Passes _) -> not (Positions.is_inside run.start)
  | _, _ -> true

let rec chain t =
  match t.because with
  | Given | Everywhere _ | Likelihood { run = None; _ } -> None
  | Parts parts -> List.find_map chain parts
  | Run { run; parts; _ } | Likelihood { run = Some (run, _); parts; _ } -> (
      match (Run.goal run, List.find_map chain parts) with
      | Some _, Some more when goes_on more -> Some (Run.append run more)
      | _ -> Some run)
