open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_semantics
open Instant
open Scc_state_sets

type due = Contact of int | Expiry of int * Linear.t | Split_instant of int | Step_end | Lots

(* {1 What comes first} *)

let contact c (a, b) =
  Meeting_cells.of_solids (c.obstacle a.solid b.solid) ~offset:(offset a b) ~velocity:(relative_velocity a b)

(* Reading I-33: open features that fit come to meet. *)
let meetings c (a, b) =
  let meeting = Meeting_cells.of_features ~offset:(offset a b) ~velocity:(relative_velocity a b) in
  if Model.binds_on_contact (Semantics.model c.semantics) then List.map meeting (meeting_offsets c (a, b)) else []

let same_due a b =
  match (a, b) with
  | Contact i, Contact j | Split_instant i, Split_instant j -> Int.equal i j
  | Expiry (i, t), Expiry (j, u) -> Int.equal i j && Linear.equal t u
  | Step_end, Step_end | Lots, Lots -> true
  | (Contact _ | Expiry _ | Split_instant _ | Step_end | Lots), _ -> false

(* The clocks of the network: the time left to the end of each. *)
let clocks (m : Model.t) (z : Zone.t) =
  let to_lots since =
    match m.splits with
    | Every step -> [ (Linear.sub (Linear.constant (Zone.dimension z) step) since, Lots) ]
    | Any_time -> []
  in
  Option.fold ~none:[] ~some:(fun left -> [ (left, Step_end) ]) z.step @ Option.fold ~none:[] ~some:to_lots z.grid

(* They matter where somebody is steered, or a bond is drawn for. *)
let clocks_matter (m : Model.t) (z : Zone.t) =
  let waits p = Steer.steers m p || Option.is_some (Scc_semantics.Lots.wait m p) in
  Array.exists waits z.skeleton.processes

let by_clocks clocks cells = List.fold_left (fun cells (left, due) -> First.at left due cells) cells clocks

let cells c z region =
  let m = Semantics.model c.semantics in
  let of_leaf cells (l : State.leaf) =
    let expire cells d = First.at (Zone_time.left z l.leaf d) (Expiry (l.leaf, d)) cells in
    List.fold_left expire cells (List.sort_uniq Linear.compare (Zone_time.lengths m l))
  in
  let tick cells (first, left) = First.at left (Split_instant first) cells in
  let clocks = clocks m z in
  let matter = clocks <> [] && clocks_matter m z in
  let start = by_clocks (if matter then clocks else []) (First.start region) in
  let expired = List.fold_left of_leaf start (State.leaves z.skeleton) in
  let by_themselves = List.fold_left tick expired (Zone_time.to_split_instants m z) in
  let meet (i, cells) (a, b) =
    let moves = not (Vec.is_zero (relative_velocity a b)) in
    let on cells comes = First.on comes (Contact i) cells in
    (i + 1, if moves then List.fold_left on cells (contact c (a, b) :: meetings c (a, b)) else cells)
  in
  (* Other clocks stop time only where something else is ahead. *)
  let beside (cell : due First.cell) =
    if matter || cell.time = None then [ cell ] else by_clocks clocks [ cell ]
  in
  List.fold_left meet (0, by_themselves) (pairs m z) |> snd |> List.concat_map beside |> First.merged same_due

(* {1 Passing} *)

let set array i x =
  let array = Array.copy array in
  array.(i) <- x;
  array

(* The delays of a leaf that have these durations, which are all the same now, expire. *)
let expire c (z : Zone.t) (leaf, durations) =
  let m = Semantics.model c.semantics in
  let passed = List.hd durations in
  let shortened (b : Behaviour.t) =
    match b with
    | Delay (_, rest) | Wait (_, rest) ->
      let d = Zone_time.length m b in
      if List.exists (Linear.equal d) durations then rest else Behaviour.wait (Linear.sub d passed) rest
    | Nil | Open _ | Weak _ | Strong _ | Sum _ | Call _ -> Scc_base.Bug.fail __POS__ "no delay"
  in
  let of_leaf (l : State.leaf) =
    if l.leaf = leaf then { l with behaviour = Behaviours.shorten m.definitions shortened l.behaviour } else l
  in
  let restarted = ref None in
  let of_process (p : State.process) =
    if not (State.has_leaf p leaf) then p
    else
      let aged = State.map_leaves of_leaf p in
      if Time.gains_split m p aged then begin
        restarted := Some p.leaves.(0).leaf;
        State.with_clock (Some Rat.zero) aged
      end
      else aged
  in
  let zero = Linear.constant (Zone.dimension z) Rat.zero in
  let skeleton = State.mapi (fun _ -> of_process) z.skeleton in
  let clocks = match !restarted with None -> z.clocks | Some first -> set z.clocks first zero in
  { z with skeleton; clocks; ages = set z.ages leaf zero }

(* By leaves, each with the durations that are over. *)
let expiries due =
  let add found = function
    | Contact _ | Split_instant _ | Step_end | Lots -> found
    | Expiry (leaf, d) ->
      let others = Option.value (List.assoc_opt leaf found) ~default:[] in
      (leaf, d :: others) :: List.remove_assoc leaf found
  in
  List.fold_left add [] due

let rec settled c (z : Zone.t) =
  let n = Zone.dimension z in
  let none f = Constraint.equals f (Linear.constant n Rat.zero) in
  let may_be_over (l : State.leaf) d =
    let c = none (Zone_time.left z l.leaf d) in
    if Polyhedron.is_empty (Polyhedron.add z.set c) then None else Some (l.leaf, d, c)
  in
  let of_leaf (l : State.leaf) =
    List.find_map (may_be_over l) (Zone_time.lengths (Semantics.model c.semantics) l)
  in
  match List.find_map of_leaf (State.leaves z.skeleton) with
  | None -> [ z ]
  | Some (leaf, d, over) ->
    let at constraint_ = { z with set = Polyhedron.add z.set constraint_ } in
    let some (z : Zone.t) = not (Polyhedron.is_empty z.set) in
    let still = List.filter some (List.map at (Constraint.negation over)) in
    List.concat_map (settled c) (expire c (at over) (leaf, [ d ]) :: still)

let step_over (s : State.t) =
  let over (step : State.step) = { step with phase = State.Due } in
  State.at ~step:(Option.map over s.step) ~time:s.time s

let is_lots = function Lots -> true | Contact _ | Expiry _ | Split_instant _ | Step_end -> false

let lots_pending (m : Model.t) (z : Zone.t) =
  match m.splits with
  | Every step -> { z with skeleton = State.mapi (fun _ p -> Scc_semantics.Lots.pass m step p) z.skeleton }
  | Any_time -> z

let until c (z : Zone.t) (cell : due First.cell) =
  let time = match cell.time with Some t -> t | None -> Scc_base.Bug.fail __POS__ "nothing comes" in
  let m = Semantics.model c.semantics in
  let z = Zone_time.after m { z with set = cell.region } time in
  let zero = Linear.constant (Zone.dimension z) Rat.zero in
  let tick (z : Zone.t) = function
    | Split_instant first -> { z with clocks = set z.clocks first zero }
    | Step_end -> { z with skeleton = step_over z.skeleton; step = Some zero }
    | Lots -> { z with grid = Some zero }
    | Contact _ | Expiry _ -> z
  in
  let z = List.fold_left tick z cell.due in
  (* Which bonds are drawn for depends on the behaviours as they are then. *)
  let drawn (z : Zone.t) = if List.exists is_lots cell.due then lots_pending m z else z in
  List.map drawn (settled c (List.fold_left (expire c) z (expiries cell.due)))

(* The states until the cell's time, over one variable more: how much time has passed, which begins as it says. *)
let until_then (c : Instant.context) (z : Zone.t) (cell : due First.cell) ~begins =
  let n = Zone.dimension z in
  let old = Array.init n (Linear.variable (n + 1)) in
  let lift f = Linear.compose f ~dimension:(n + 1) old in
  let passed = Linear.variable (n + 1) n in
  let within =
    begins passed (Linear.constant (n + 1) Rat.zero)
    :: List.map (fun t -> Constraint.less passed (lift t)) (Option.to_list cell.time)
  in
  let set = Polyhedron.add_all (Polyhedron.embed cell.region ~dimension:(n + 1) (Array.init n Fun.id)) within in
  Zone_time.after (Semantics.model c.semantics) (Zone.with_variables z ~dimension:(n + 1) old set) passed

let trajectory c z cell = until_then c z cell ~begins:Constraint.greater
let within c z cell = { (until_then c z cell ~begins:Constraint.at_least) with halted = true }
