open Scc_exact
open Scc_polyhedra
open Scc_property
open Scc_state_sets
open Chance_tree
module Truth = Scc_ctl.Truth

type wanted = Chance | Time | Happenings of Property.prop | Value_at of Property.num * Rat.t
type question = { wanted : wanted; claim : Property.prop; goal : Property.prop; bound : Property.bound }

let about number : Property.prop = Compare (Eq, number, Const Rat.zero)

let same_wanted a b =
  match (a, b) with
  | Chance, Chance | Time, Time -> true
  | Happenings p, Happenings q -> Formula.equal_prop p q
  | Value_at (n, t), Value_at (m, u) -> Rat.equal t u && Formula.equal_prop (about n) (about m)
  | (Chance | Time | Happenings _ | Value_at _), _ -> false

let same_question a b =
  same_wanted a.wanted b.wanted
  && Formula.equal_prop a.claim b.claim && Formula.equal_prop a.goal b.goal
  && Rat.equal a.bound.low b.bound.low
  && Option.equal Rat.equal a.bound.high b.bound.high

let predicates question =
  let number = match question.wanted with Value_at (n, _) -> [ about n ] | Chance | Time | Happenings _ -> [] in
  question.claim :: question.goal :: number

type t = {
  context : Instant.context;
  atoms : Atoms.context;
  events : Property.event array;
  question : question;
  goal : Atoms.view -> (Polyhedron.t * Truth.t) list;
  claim : Atoms.view -> (Polyhedron.t * Truth.t) list;
  mutable reasons : string list;
}

let make context (question : question) =
  let formulas = List.map (fun p -> Property.State p) (predicates question) in
  let events = Scc_data.Lists.distinct Formula.equal_event (List.concat_map Formula.events formulas) in
  let events = Array.of_list events in
  let atoms = Atoms.context context ~events in
  let goal = Atoms.truth atoms question.goal and claim = Atoms.truth atoms question.claim in
  { context; atoms; events; question; goal; claim; reasons = [] }

let question t = t.question
let events t = t.events

let see_speed t =
  let sees p = List.exists (Atom.depends_on Speed) (Formula.atoms (Property.State p)) in
  List.exists sees (predicates t.question)

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

(* {1 Means} *)

let gain least most tree = Gain { least; most; tree }
let after_time t time tree = match t.question.wanted with Time -> gain time time tree | _ -> tree

let after_happening t (z : Zone.t) ~source label tree =
  match t.question.wanted with
  | Chance | Time | Value_at _ -> tree
  | Happenings p ->
    let { Scc_evaluate.Counted.least; most } = Scc_evaluate.Counted.by t.context.semantics ~source label p in
    let number k = Linear.constant (Zone.dimension z) (Rat.of_int k) in
    if most = 0 then tree else gain (number least) (number most) tree

let depends_on_instants t = match t.question.wanted with Time | Value_at _ -> true | Chance | Happenings _ -> false

let at_dead_end t =
  match t.question.wanted with
  | Chance | Time | Happenings _ -> Lost
  | Value_at _ -> undecided t "a run may end in a dead end before the number is taken"

(* The lower bounds that a polyhedron sets to its last variable, over the others. *)
let lower_ends ~n p =
  let of_constraint (c : Constraint.t) =
    let a = c.normal.(n) in
    if Z.sign a < 0 || (Z.sign a > 0 && c.relation = Equal) then
      let part k = Rat.make (Z.neg k) a in
      Some (Linear.make ~constant:(Rat.make c.right a) (Array.map part (Array.sub c.normal 0 n)))
    else None
  in
  List.filter_map of_constraint (Polyhedron.constraints p)

(* Regions of the others with the least value of the last variable, which need not be attained. *)
let infima ~n p =
  let there = Polyhedron.project p (Array.init n Fun.id) in
  let ends = List.sort_uniq Linear.compare (lower_ends ~n p) in
  let of_end i f =
    let beyond j g =
      if i = j then [] else [ (if j < i then Constraint.greater f g else Constraint.at_least f g) ]
    in
    List.map (fun q -> (q, f)) (Region.where there (List.concat (List.mapi beyond ends)))
  in
  List.concat (List.mapi of_end ends)

(* The first of what may come on some regions, which are made disjoint. *)
let first_of all =
  let add found (region, time) =
    let beside (left, kept) (r, u) =
      let of_left p =
        match Region.split p (Polyhedron.constraints r) with
        | None, rest -> (rest, [])
        | Some both, rest ->
          let earlier, later = Region.split both [ Constraint.less time u ] in
          (rest, List.map (fun q -> (q, time)) (Option.to_list earlier) @ List.map (fun q -> (q, u)) later)
      in
      let others = snd (Region.split r (Polyhedron.constraints region)) in
      let parts = List.map of_left left in
      (List.concat_map fst parts, List.map (fun q -> (q, u)) others @ List.concat_map snd parts @ kept)
    in
    let left, kept = List.fold_left beside ([ region ], []) found in
    List.map (fun q -> (q, time)) left @ kept
  in
  List.fold_left add [] all

(* When the goal comes first. What is not known may come before. *)
let first_times t (z : Zone.t) (cell : Passing.due First.cell) =
  let n = Zone.dimension z in
  let w = on_the_way t (Passing.trajectory t.context z cell) in
  let none = Union.empty n in
  let parts = divided cell.region { won = none; open_ = project w.open_ ~dimension:n; lost = none } in
  let won = first_of (List.concat_map (infima ~n) (Union.pieces w.won)) in
  let of_part (region, met) =
    let cut (left, found) (p, time) =
      let cut_one q =
        let inside, rest = Region.split q (Polyhedron.constraints p) in
        (List.map (fun q -> (q, Some (gain time time Won))) (Option.to_list inside), rest)
      in
      let parts = List.map cut_one left in
      (List.concat_map snd parts, List.concat_map fst parts @ found)
    in
    match met with
    | Some _ -> [ (region, met) ]
    | None ->
      let left, found = List.fold_left cut ([ region ], []) won in
      List.map (fun q -> (q, None)) left @ found
  in
  List.concat_map of_part parts

let value t number ~passing (z : Zone.t) =
  let known (p, v) = (p, Some (match v with Ok form -> Is form | Error reason -> undecided t reason)) in
  List.map known (Atoms.number t.atoms number { zone = z; passing; quiescent = [] })

(* Where the time comes before the next event, the number is taken. *)
let at_time t (z : Zone.t) (cell : Passing.due First.cell) number time =
  let zero = Linear.constant (Zone.dimension z) Rat.zero in
  let left =
    match z.time with
    | Some now -> Linear.sub (Linear.constant (Zone.dimension z) time) now
    | None -> Scc_base.Bug.fail __POS__ "time is asked for, and not kept"
  in
  let goes_on, here =
    match cell.time with
    | None -> (None, [ cell.region ])
    | Some next -> Region.split cell.region [ Constraint.at_most next left ]
  in
  let taken region =
    let at_once, passing = Region.split region [ Constraint.equals left zero ] in
    let later set = Zone_time.after (Scc_semantics.Semantics.model t.context.semantics) { z with set } left in
    List.concat_map (fun set -> value t number ~passing:false { z with set }) (Option.to_list at_once)
    @ List.concat_map (fun set -> value t number ~passing:true (later set)) passing
  in
  List.map (fun p -> (p, None)) (Option.to_list goes_on) @ List.concat_map taken here

let along t (z : Zone.t) (cell : Passing.due First.cell) =
  match t.question.wanted with
  | Value_at (number, time) -> at_time t z cell number time
  | Chance | Time | Happenings _ when nothing_on_the_way t -> [ (cell.region, None) ]
  | Time -> first_times t z cell
  | Chance | Happenings _ ->
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
