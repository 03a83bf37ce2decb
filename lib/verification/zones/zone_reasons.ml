open Scc_exact
open Scc_semantics
open Scc_property
open Scc_evaluate
open Scc_symbolic
open Scc_explain
module R = Zone_established

let facts_at (r : R.t) (spot : Shown_run.spot) prop =
  let extent = match spot.since with None -> Scc_ctl.Timeline.Instant | Some _ -> R.extent r spot.steps in
  let offset = Algebraic.of_rat (Option.value spot.since ~default:Rat.zero) in
  let prop = Rename.known r.values prop in
  Facts.at ~arrived:(R.arrived r spot.steps) r.semantics (R.state r spot.steps) extent offset prop

let rec given (r : R.t) (c : Shown_run.claim) =
  match (Formula.state_formula c.formula, c.because) with
  | Some prop, _ -> facts_at r c.spot prop
  | None, Parts parts -> List.concat_map (given r) parts
  | None, Run { along = Some a; goal; finish; _ } -> at_last r finish a goal
  | None, (Given | Everywhere | Run _) -> []

(* Where the run passes the bound, or in the state where it ends; or in the middle of the bound, if that begins
   later and time gets there. *)
and at_last r finish (a : Shown_run.along) goal =
  let early = Rat.sub a.bound.low (R.clock r goal.steps) in
  let lasts = match a.bound.high with Some h -> Rat.sub h a.bound.low | None -> Rat.zero in
  match (Formula.state_formula a.what, (finish : Shown_run.finish)) with
  | None, _ -> []
  | Some prop, Passes bound when Rat.compare bound (R.clock r goal.steps) > 0 ->
    facts_at r { goal with since = Some (Rat.sub bound (R.clock r goal.steps)) } prop
  | Some prop, _ when Rat.sign early <= 0 -> facts_at r { goal with since = None } prop
  | Some prop, Rests ->
    facts_at r { goal with since = Some (Rat.add early (Rat.mul Rat.half lasts)) } prop
  | Some _, (There | Passes _ | Repeats _ | Goes_on _) -> []

let rec last_run (c : Shown_run.claim) =
  match c.because with
  | Given | Everywhere -> None
  | Parts parts -> List.find_map last_run parts
  | Run { parts; _ } -> ( match List.find_map last_run parts with Some _ as run -> run | None -> Some c)

let facts r (c : Shown_run.claim) =
  match last_run c with
  | Some { because = Run { finish = There; parts; _ }; _ } ->
    Scc_data.Lists.distinct String.equal (List.concat_map (given r) parts)
  | Some { because = Run { along = Some a; goal; finish; _ }; _ } -> at_last r finish a goal
  | Some _ | None -> []

let right_after (r : R.t) c =
  match last_run c with
  | Some { because = Run { finish = There; until; goal; _ }; _ } when not (Shown_run.equal_spots until goal) ->
    let since = Option.value until.since ~default:Rat.zero in
    Some (Rat.sub (Rat.add (R.clock r until.steps) since) (R.clock r goal.steps))
  | Some _ | None -> None

(* {1 The tree} *)

let instant r (s : Shown_run.spot) = Rat.add (R.clock r s.steps) (Option.value s.since ~default:Rat.zero)

(* What happens on the run between two of its positions, and how long that takes. *)
let story model (r : R.t) (from : Shown_run.spot) (until : Shown_run.spot) =
  let start = instant r from in
  let event k =
    let s = r.steps.(k) in
    match s.transition.label with
    | Time _ -> None
    | label ->
      let after = Rat.to_string (Rat.sub s.time start) in
      Some (Printf.sprintf "%s after %s" (Transition.label_to_string model label) after)
  in
  let events = List.filter_map event (List.init (until.steps - from.steps) (fun i -> from.steps + i)) in
  (Rat.sub (instant r until) start, events)

let ending model r (from : Shown_run.spot) ~until (goal : Shown_run.spot) finish =
  let clock, events = story model r from goal in
  match (finish : Shown_run.finish) with
  | There when not (Shown_run.equal_spots until goal) ->
    Printf.sprintf "right after time %s from here, for example after %s"
      (Rat.to_string (fst (story model r from until)))
      (Rat.to_string clock)
  | There when Shown_run.equal_spots from goal -> "here"
  | There when goal.since = None -> Printf.sprintf "in the state after time %s from here" (Rat.to_string clock)
  | There -> Printf.sprintf "after time %s from here" (Rat.to_string clock)
  | Rests -> "the run then rests for ever"
  | Passes bound ->
    Printf.sprintf "the run then passes the bound of time, which ends after time %s from here"
      (Rat.to_string (Rat.sub bound (instant r from)))
  | Goes_on _ -> "the run then goes on for ever"
  | Repeats k ->
    let k = Int.max k from.steps in
    let clock, before = story model r from { steps = k; since = None } in
    Wording.going_round (k - from.steps) ~silent:(List.compare_lengths before events = 0) clock

let affirmed (c : Shown_run.claim) =
  match c.formula with State (Not p) -> (Property.State p, not c.holds) | f -> (f, c.holds)

let rec tree model r (c : Shown_run.claim) : Witness.argument =
  let formula, holds = affirmed c in
  let claim = Show.temporal model (Rename.known_temporal r.R.values formula) in
  let because, parts =
    match (Formula.state_formula c.formula, c.because) with
    | Some prop, _ -> (facts_at r c.spot prop, [])
    | None, Given -> ([], [])
    | None, Everywhere -> ([ "all runs from there were looked at" ], [])
    | None, Parts parts -> ([], List.map (tree model r) parts)
    | None, Run { finish; until; goal; along; parts } ->
      let _, events = story model r c.spot goal in
      let parts = List.map (tree model r) parts @ Option.to_list (on_the_way model r finish along) in
      (Wording.listed events @ [ ending model r c.spot ~until goal finish ], parts)
  in
  let because = List.filter_map (Wording.beyond claim holds) because in
  { where = None; time = None; claim; holds; because; parts }

and on_the_way model r finish = function
  | Some { what; so; _ } when Formula.state_formula what = None ->
    let claim = Show.temporal model (Rename.known_temporal r.R.values what) in
    let where = if finish = Shown_run.There then "all the way" else "everywhere on this run" in
    let because = [ "that is known of all states that it goes through" ] in
    Some { where = Some where; time = None; claim; holds = so; because; parts = [] }
  | Some _ | None -> None

let rec is_plain (c : Shown_run.claim) =
  match c.because with
  | Given -> true
  | Everywhere | Run _ -> false
  | Parts parts -> List.for_all is_plain parts

let argument model r (c : Shown_run.claim) =
  let is_told (a : Shown_run.along) = Option.is_some (Formula.state_formula a.what) in
  match c.because with
  | Run { parts; along; _ } when List.for_all is_plain parts && Option.fold ~none:true ~some:is_told along -> None
  | Run _ | Given | Parts _ | Everywhere -> Some (tree model r c)
