open Scc_exact
open Scc_polyhedra
open Scc_property
open Scc_state_sets
open Chance_tree
module Truth = Scc_ctl.Truth

type question = { claim : Property.prop; goal : Property.prop; bound : Property.bound }

let same_question a b =
  Formula.equal_prop a.claim b.claim && Formula.equal_prop a.goal b.goal
  && Rat.equal a.bound.low b.bound.low
  && Option.equal Rat.equal a.bound.high b.bound.high

type t = {
  context : Instant.context;
  events : Property.event array;
  question : question;
  goal : Atoms.view -> (Polyhedron.t * Truth.t) list;
  claim : Atoms.view -> (Polyhedron.t * Truth.t) list;
  mutable reasons : string list;
}

let make context (question : question) =
  let formulas = [ Property.State question.claim; State question.goal ] in
  let events = Scc_data.Lists.distinct Formula.equal_event (List.concat_map Formula.events formulas) in
  let events = Array.of_list events in
  let atoms = Atoms.context context ~events in
  let goal = Atoms.truth atoms question.goal and claim = Atoms.truth atoms question.claim in
  { context; events; question; goal; claim; reasons = [] }

let events t = t.events
let see_speed t =
  let sees p = List.exists (Atom.depends_on Speed) (Formula.atoms (Property.State p)) in
  sees t.question.claim || sees t.question.goal

let reasons t = List.sort String.compare t.reasons

(* {1 Predicates} *)

let undecided t reason =
  if not (List.mem reason t.reasons) then t.reasons <- reason :: t.reasons;
  Open

(* The regions where the elapsed time is within the bound, after [passed], and the others. *)
let in_time t (z : Zone.t) region =
  let bound = t.question.bound in
  match z.time with
  | None -> ([ region ], [])
  | Some time ->
    let known q = Linear.constant (Zone.dimension z) q in
    let low = if Rat.sign bound.low > 0 then [ Constraint.at_least time (known bound.low) ] else [] in
    let high = List.map (fun h -> Constraint.at_most time (known h)) (Option.to_list bound.high) in
    let yes, no = Region.split region (low @ high) in
    (Option.to_list yes, no)

let not_after_time horizon (z : Zone.t) region =
  match (z.time, horizon) with
  | Some time, Some h ->
    let yes, no = Region.split region [ Constraint.at_most time (Linear.constant (Zone.dimension z) h) ] in
    (Option.to_list yes, no)
  | None, _ | _, None -> ([ region ], [])

(* What is known at an instant: [None] where the run has to go on. *)
let judged t (z : Zone.t) =
  let view set = { Atoms.zone = { z with set }; passing = false; quiescent = [] } in
  let by_claim region =
    let one (p, (truth : Truth.t)) =
      (p, match truth with True -> None | False -> Some Lost | Undecided reason -> Some (undecided t reason))
    in
    List.map one (t.claim (view region))
  in
  let by_goal (p, (truth : Truth.t)) =
    match truth with
    | Undecided reason -> [ (p, Some (undecided t reason)) ]
    | False -> by_claim p
    | True ->
      let yes, no = in_time t z p in
      List.map (fun q -> (q, Some Won)) yes @ List.concat_map by_claim no
  in
  let timely, late = not_after_time t.question.bound.high z z.set in
  List.concat_map (fun p -> List.concat_map by_goal (t.goal (view p))) timely
  @ List.map (fun p -> (p, Some Lost)) late

(* {1 Between two events} *)

let project u ~dimension = Union.map ~dimension (fun p -> Polyhedron.project p (Array.init dimension Fun.id)) u

(* Sets (y, d) as sets (y, ..., d), where y are [n] variables and d has the place [at] of [dimension]. *)
let moved u ~n ~dimension at =
  let places = Array.init (n + 1) (fun i -> if i < n then i else at) in
  Union.map ~dimension (fun p -> Polyhedron.embed p ~dimension places) u

let restrict u constraints =
  Union.map ~dimension:(Union.dimension u) (fun p -> Polyhedron.add_all p constraints) u

let variable = Linear.variable

(* Of (y, d) those that no (y, d') of another set with d' < d comes before. *)
let not_after ~n bad states =
  if Union.is_empty bad || Union.is_empty states then states
  else
    let dimension = n + 2 in
    let earlier = Constraint.less (variable dimension (n + 1)) (variable dimension n) in
    let any_later = Union.of_polyhedron (Polyhedron.add (Polyhedron.universe dimension) earlier) in
    let before = Union.inter any_later (moved bad ~n ~dimension (n + 1)) in
    Union.difference states (project before ~dimension:(n + 1))

(* The states (y, d) of a trajectory at which the goal comes first, at which something is not known, and at
   which the claim fails. *)
type met_on_the_way = { won : Union.t; open_ : Union.t; lost : Union.t }

let on_the_way t (z : Zone.t) =
  let n = Zone.dimension z - 1 in
  let view = { Atoms.zone = z; passing = true; quiescent = [] } in
  let of_truth truth test = List.filter_map (fun (p, x) -> if test x then Some p else None) truth in
  let set pieces = Union.of_polyhedra (n + 1) pieces in
  let goal = t.goal view and claim = t.claim view in
  let is_true = Truth.equal True and is_false = Truth.equal False in
  let is_open = function Truth.Undecided reason -> ignore (undecided t reason); true | True | False -> false in
  let in_window = List.concat_map (fun p -> fst (in_time t z p)) in
  let lost = set (of_truth claim is_false) in
  let open_claim = set (of_truth claim is_open) and open_goal = set (in_window (of_truth goal is_open)) in
  let bad = Union.union lost open_claim in
  let won = not_after ~n bad (set (in_window (of_truth goal is_true))) in
  { won; open_ = Union.union open_claim open_goal; lost }

(* A region by what is first met on the way; the sets are over its variables. *)
let divided region { won; open_; lost } =
  let take (rest, found) (set, tree) =
    let inside = Union.disjoint (Union.inter rest set) in
    (Union.difference rest inside, List.map (fun p -> (p, Some tree)) (Union.pieces inside) @ found)
  in
  let all = [ (won, Won); (open_, Open); (lost, Lost) ] in
  let rest, found = List.fold_left take (Union.of_polyhedron region, []) all in
  List.map (fun p -> (p, None)) (Union.pieces (Union.disjoint rest)) @ List.rev found

let is_steady (p : Property.prop) = Formula.steady ~rigid:false p && not (Formula.has_events (State p))

(* Nothing that counts can be met on the way: it was so when it began. *)
let nothing_on_the_way t =
  is_steady t.question.claim && is_steady t.question.goal && Rat.sign t.question.bound.low = 0

let along t (z : Zone.t) (cell : Passing.due First.cell) =
  if nothing_on_the_way t then [ (cell.region, None) ]
  else
    let project u = project u ~dimension:(Zone.dimension z) in
    let w = on_the_way t (Passing.trajectory t.context z cell) in
    divided cell.region { won = project w.won; open_ = project w.open_; lost = project w.lost }

(* Where time stops for a split: what was met until then, over one more variable. *)
let along_until_stop t (z : Zone.t) (cell : Passing.due First.cell) (halted : Zone.t) =
  if nothing_on_the_way t then [ (halted.set, None) ]
  else
    let n = Zone.dimension z in
    let w = on_the_way t (Passing.trajectory t.context z cell) in
    let dimension = n + 2 in
    let no_later = Constraint.at_most (variable dimension (n + 1)) (variable dimension n) in
    let until u = project (restrict (moved u ~n ~dimension (n + 1)) [ no_later ]) ~dimension:(n + 1) in
    divided halted.set { won = until w.won; open_ = until w.open_; lost = until w.lost }
