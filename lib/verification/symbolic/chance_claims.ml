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

(* What becomes of the states of a region: [None] where the run has to go on; and what may have come before that,
   where a predicate is undecided. *)
type met = { region : Polyhedron.t; perhaps : tree list; met : tree option }

let going_on region = { region; perhaps = []; met = None }
let sure region met = { region; perhaps = []; met = Some met }

let one_of perhaps tree = if perhaps = [] then tree else Perhaps (tree :: perhaps)

let note t reason = if not (List.mem reason t.reasons) then t.reasons <- reason :: t.reasons

let undecided t reason =
  note t reason;
  Open

let judged t (z : Zone.t) =
  let view set = { Atoms.zone = { z with set }; passing = false; quiescent = [] } in
  let by_claim perhaps region =
    let one (region, (truth : Truth.t)) =
      match truth with
      | True -> { region; perhaps; met = None }
      | False -> { region; perhaps; met = Some Lost }
      | Undecided reason ->
        note t reason;
        { region; perhaps = Lost :: perhaps; met = None }
    in
    List.map one (t.claim (view region))
  in
  let by_goal (p, (truth : Truth.t)) =
    match truth with
    | False -> by_claim [] p
    | True ->
      let yes, no = in_time t z p in
      List.map (fun q -> sure q Won) yes @ List.concat_map (by_claim []) no
    | Undecided reason ->
      note t reason;
      let yes, no = in_time t z p in
      List.concat_map (by_claim [ Won ]) yes @ List.concat_map (by_claim []) no
  in
  let timely, late = not_after_time t.question.bound.high z z.set in
  List.concat_map (fun p -> List.concat_map by_goal (t.goal (view p))) timely
  @ List.map (fun p -> sure p Lost) late

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

(* The states (y, d) of a trajectory at which the goal comes first, for sure or if the claim holds wherever it is
   undecided; at which the goal is undecided, and neither has come nor was lost; at which the claim is undecided;
   and at which it fails. *)
type on_the_way = {
  won : Union.t;
  won_perhaps : Union.t;
  open_goal : Union.t;
  open_claim : Union.t;
  lost : Union.t;
}

let on_the_way t (z : Zone.t) =
  let n = Zone.dimension z - 1 in
  let view = { Atoms.zone = z; passing = true; quiescent = [] } in
  let of_truth truth test = List.filter_map (fun (p, x) -> if test x then Some p else None) truth in
  let set pieces = Union.of_polyhedra (n + 1) pieces in
  let goal = t.goal view and claim = t.claim view in
  let is_true = Truth.equal True and is_false = Truth.equal False in
  let is_open = function Truth.Undecided reason -> note t reason; true | True | False -> false in
  let in_window = List.concat_map (fun p -> fst (in_time t z p)) in
  let lost = set (of_truth claim is_false) in
  let open_claim = set (of_truth claim is_open) and open_goal = set (in_window (of_truth goal is_open)) in
  let goal = set (in_window (of_truth goal is_true)) in
  let open_goal = not_after ~n (Union.union lost goal) open_goal in
  {
    won = not_after ~n (Union.union lost open_claim) goal;
    won_perhaps = (if Union.is_empty open_claim then Union.empty (n + 1) else not_after ~n lost goal);
    open_goal; open_claim; lost;
  }

let over f w =
  {
    won = f w.won; won_perhaps = f w.won_perhaps; open_goal = f w.open_goal; open_claim = f w.open_claim;
    lost = f w.lost;
  }

(* Those inside of a set, and the others. *)
let cut set p =
  if Union.is_empty set then ([], [ p ])
  else
    let u = Union.of_polyhedron p in
    let inside = Union.disjoint (Union.inter u set) in
    (Union.pieces inside, Union.pieces (Union.disjoint (Union.difference u inside)))

(* A region by what is first met on the way; the sets are over its variables. *)
let divided region w =
  let take set tree regions =
    let cuts = List.map (fun (p, perhaps) -> (cut set p, perhaps)) regions in
    let found ((inside, _), perhaps) = List.map (fun region -> { region; perhaps; met = Some tree }) inside in
    let left ((_, outside), perhaps) = List.map (fun p -> (p, perhaps)) outside in
    (List.concat_map found cuts, List.concat_map left cuts)
  in
  let may_be set tree regions =
    let one (p, perhaps) =
      let inside, outside = cut set p in
      List.map (fun q -> (q, tree :: perhaps)) inside @ List.map (fun q -> (q, perhaps)) outside
    in
    List.concat_map one regions
  in
  let won, rest = take w.won Won [ (region, []) ] in
  let rest = may_be w.open_claim Lost (may_be w.open_goal Won rest) in
  let won_perhaps, rest = take w.won_perhaps Won rest in
  let lost, rest = take w.lost Lost rest in
  won @ won_perhaps @ lost @ List.map (fun (region, perhaps) -> { region; perhaps; met = None }) rest

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
  | Value_at _ ->
    note t "a run may end in a dead end before the number is taken";
    Open

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

(* When the goal comes first; and when it may come before, where it is undecided. *)
let first_times t (z : Zone.t) (cell : Passing.due First.cell) =
  let n = Zone.dimension z in
  let w = on_the_way t (Passing.trajectory t.context z cell) in
  let times u = first_of (List.concat_map (infima ~n) (Union.pieces u)) in
  let by_times times here found left regions =
    let one (left_out, parts) (p, time) =
      let cut_one (q, perhaps) =
        let inside, rest = Region.split q (Polyhedron.constraints p) in
        (List.map (fun q -> here q perhaps (gain time time Won)) (Option.to_list inside),
         List.map (fun q -> (q, perhaps)) rest)
      in
      let cuts = List.map cut_one left_out in
      (List.concat_map snd cuts, List.concat_map fst cuts @ parts)
    in
    let rest, parts = List.fold_left one (regions, []) times in
    found parts @ left rest
  in
  let undecided, decided = cut (project w.open_claim ~dimension:n) cell.region in
  let regions =
    by_times (times w.open_goal)
      (fun q perhaps tree -> (q, tree :: perhaps))
      Fun.id Fun.id
      (List.map (fun q -> (q, [])) decided)
  in
  List.map (fun p -> sure p Open) undecided
  @ by_times (times w.won)
    (fun region perhaps tree -> { region; perhaps; met = Some tree })
    Fun.id
    (List.map (fun (region, perhaps) -> { region; perhaps; met = None }))
    regions

let value t number ~passing (z : Zone.t) =
  let known (p, v) = sure p (match v with Ok form -> Is form | Error reason -> undecided t reason) in
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
  List.map going_on (Option.to_list goes_on) @ List.concat_map taken here

let along t (z : Zone.t) (cell : Passing.due First.cell) =
  match t.question.wanted with
  | Value_at (number, time) -> at_time t z cell number time
  | Chance | Time | Happenings _ when nothing_on_the_way t -> [ going_on cell.region ]
  | Time -> first_times t z cell
  | Chance | Happenings _ ->
    let project u = project u ~dimension:(Zone.dimension z) in
    divided cell.region (over project (on_the_way t (Passing.trajectory t.context z cell)))

(* Where time stops for a split: what was met until then, over one more variable. *)
let along_until_stop t (z : Zone.t) (cell : Passing.due First.cell) (halted : Zone.t) =
  if nothing_on_the_way t then [ going_on halted.set ]
  else
    let n = Zone.dimension z in
    let w = on_the_way t (Passing.trajectory t.context z cell) in
    let dimension = n + 2 in
    let no_later = Constraint.at_most (variable dimension (n + 1)) (variable dimension n) in
    let until u = project (restrict (moved u ~n ~dimension (n + 1)) [ no_later ]) ~dimension:(n + 1) in
    divided halted.set (over until w)
