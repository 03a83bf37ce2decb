open Scc_ctl
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_evaluate
open Scc_symbolic
open Scc_explain

type t = { semantics : Semantics.t; values : Rat.t array; initial : State.t; steps : Witness.step array }

let length r = Array.length r.steps
let state r k = if k = 0 then r.initial else r.steps.(k - 1).transition.target
let clock r k = if k = 0 then Rat.zero else r.steps.(k - 1).time

let arrived r k event =
  k > 0 && Event.matches ~source:(state r (k - 1)) r.steps.(k - 1).transition.label event

let undisturbed r k =
  match Network.successors r.semantics (state r k) with
  | Ok all -> not (List.exists (fun (t : Transition.t) -> Transition.is_urgent t.label) all)
  | Error _ -> false

let extent r k : Timeline.extent =
  if k < length r then
    match r.steps.(k).transition.label with Time d -> Lasts d | _ -> Instant
  else if not (undisturbed r k) then Instant
  else match Time.delay r.semantics (state r k) with Some d -> Lasts d | None -> Forever

let trajectory r k = Trajectory.make ~arrived:(arrived r k) r.semantics (state r k) (extent r k)

(* {1 Between two instants} *)

(* From an offset on, until before another one. *)
type window = { from : Rat.t; until : Rat.t option }

let whole = { from = Rat.zero; until = None }

(* Whether a predicate is so at all offsets of a window that are in time, of those before what comes next. *)
let all_along r k prop ~so ~(bound : Property.bound) window =
  let since = clock r k and timeline = Trajectory.prop (trajectory r k) prop in
  let lasts = match timeline.extent with Lasts d -> Some d | Instant | Forever -> None in
  let window = { window with until = Option.merge Rat.min window.until lasts } in
  let low = Rat.max window.from (Rat.sub bound.low since) in
  let high = Option.map (fun h -> Rat.sub h since) bound.high in
  let in_window offset =
    Algebraic.compare_rat offset low >= 0
    && Option.fold ~none:true ~some:(fun h -> Algebraic.compare_rat offset h <= 0) high
    && Option.fold ~none:true ~some:(fun u -> Algebraic.compare_rat offset u < 0) window.until
  in
  let ends = Option.merge Rat.min high window.until in
  (* Of an open interval, some of which may be in the window. *)
  let meets from until =
    let before_end = Option.fold ~none:true ~some:(fun e -> Algebraic.compare_rat from e < 0) ends in
    let after_low = Option.fold ~none:true ~some:(fun u -> Algebraic.compare_rat u low > 0) until in
    let low_counts () = in_window (Algebraic.of_rat low) in
    let is_some = Option.fold ~none:true ~some:(fun e -> Rat.compare low e < 0 || low_counts ()) ends in
    before_end && after_low && is_some
  in
  let is_so = Truth.equal (if so then Truth.True else False) in
  let rec pieces = function
    | [] -> true
    | (piece : Truth.t Timeline.piece) :: rest ->
      let until = match rest with [] -> None | next :: _ -> Some next.cut in
      (is_so piece.at || not (in_window piece.cut))
      && (is_so piece.after || not (meets piece.cut until))
      && pieces rest
  in
  let first_cut = match timeline.rest with [] -> None | p :: _ -> Some p.cut in
  let start = Algebraic.of_rat Rat.zero in
  (is_so timeline.start || not (in_window start))
  && (timeline.extent = Instant || is_so timeline.first || not (meets start first_cut))
  && pieces timeline.rest

(* Whether the state after so many steps comes within a bound, which counts from the start. *)
let in_time r (bound : Property.bound) k =
  let now = clock r k in
  Rat.compare bound.low now <= 0 && Option.fold ~none:true ~some:(fun h -> Rat.compare now h <= 0) bound.high

let at r (spot : Shown_run.spot) prop ~holds =
  let timeline = Trajectory.prop (trajectory r spot.steps) prop in
  let offset = Option.value spot.since ~default:Rat.zero in
  let truth = if Rat.sign offset = 0 then timeline.start else Timeline.at timeline (Algebraic.of_rat offset) in
  Truth.equal truth (if holds then True else False)

(* {1 Claims} *)

(* From a position of the run until its goal, or all of it. *)
let on_the_way r (from : Shown_run.spot) (goal : Shown_run.spot) finish prop ~so ~bound =
  let all_of k window = all_along r k prop ~so ~bound window in
  let start k = if k = from.steps then Option.value from.since ~default:Rat.zero else Rat.zero in
  let rec before k = k >= goal.steps || (all_of k { whole with from = start k } && before (k + 1)) in
  before from.steps
  &&
  match ((finish : Shown_run.finish), goal.since) with
  | There, None -> true
  | There, Some d -> all_of goal.steps { from = start goal.steps; until = Some d }
  | (Rests | Passes _), _ -> all_of goal.steps { whole with from = start goal.steps }
  | (Repeats _ | Goes_on _), _ ->
    (not (in_time r bound goal.steps)) || at r { steps = goal.steps; since = None } prop ~holds:so

let ends r (goal : Shown_run.spot) finish ~(bound : Property.bound) =
  let here = state r goal.steps in
  match (finish : Shown_run.finish) with
  | There -> true
  | Goes_on k -> k < goal.steps
  | Repeats k -> k < goal.steps && Option.is_some (Make_witness.moved (state r k) here)
  | Rests -> undisturbed r goal.steps && Time.delay r.semantics here = None
  | Passes _ -> (
      undisturbed r goal.steps
      &&
      match (Time.delay r.semantics here, bound.high) with
      | None, _ -> true
      | Some d, Some h -> Rat.compare (Rat.add (clock r goal.steps) d) h > 0
      | Some _, None -> false)

(* The next event is the last step to the goal. *)
let is_next r (from : Shown_run.spot) (goal : Shown_run.spot) =
  let is_event k = not (Transition.is_time r.steps.(k).transition.label) in
  let events = List.filter is_event (List.init (goal.steps - from.steps) (fun i -> from.steps + i)) in
  events = [ goal.steps - 1 ] && goal.since = None

let rec claim r (c : Shown_run.claim) =
  match (Formula.state_formula c.formula, c.because) with
  | Some prop, _ -> at r c.spot (Rename.known r.values prop) ~holds:c.holds
  | None, (Given | Everywhere) -> true
  | None, Parts parts -> List.for_all (claim r) parts
  | None, Run { finish; until; goal; along; parts } ->
    let bound = match along with Some a -> a.bound | None -> { low = Rat.zero; high = None } in
    let way (a : Shown_run.along) =
      match Formula.state_formula a.what with
      | Some prop -> on_the_way r c.spot until finish (Rename.known r.values prop) ~so:a.so ~bound:a.bound
      | None -> true
    in
    let next = match c.formula with Next _ -> is_next r c.spot goal | _ -> true in
    next && Option.fold ~none:true ~some:way along && ends r goal finish ~bound && List.for_all (claim r) parts
