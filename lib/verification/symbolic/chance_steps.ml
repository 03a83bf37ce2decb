open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_semantics
open Scc_state_sets

exception Bad of { fault : Transition.fault; at : Rat.t array }

let model (c : Instant.context) = Semantics.model c.semantics

(* A state of a region, the rules for it, and what raises its faults. *)
type sample = { state : State.t; semantics : Semantics.t; values : Rat.t array }

let sample c (z : Zone.t) region =
  match Polyhedron.point region with
  | None -> Scc_base.Bug.fail __POS__ "an empty region"
  | Some point ->
    let s = Zone.at z point in
    let time = Option.map (fun t -> Linear.eval t point) z.time in
    let state = State.at ~step:s.step ~time s in
    { state; semantics = Instant.semantics_at c z point; values = Zone.values z point }

let sure s = function Ok x -> x | Error fault -> raise (Bad { fault; at = s.values })

(* {1 Laws} *)

let is_steered (s : State.t) = match s.step with Some { phase = Steered; _ } -> true | _ -> false

(* A zone like [z] on the region, for what a transition without time makes of its states. *)
let converted c (z : Zone.t) region (target : State.t) =
  let skeleton = Zone.skeleton (State.at ~step:target.step ~time:None target) in
  let begins = is_steered target && not (is_steered z.skeleton) in
  let whole = Linear.constant (Zone.dimension z) (model c).timestep in
  { z with skeleton; set = region; step = (if begins then Some whole else z.step) }

let waits (p : State.process) = match p.draw with Some Waits -> true | Some (Drawn _) | None -> false
let is_drawing (s : State.t) = Array.exists (fun (p : State.process) -> Option.is_some p.draw) s.processes

let is_due (s : State.t) =
  match s.step with
  | Some { phase = Due; _ } -> not (is_drawing s || Lots.pending s)
  | Some { phase = Moving | Steered; _ } | None -> false

(* A region by what the laws of some processes give. *)
let by_laws c (z : Zone.t) asked region =
  let cut regions p =
    if asked p then List.concat_map (fun r -> Law_cells.cells c z r p) regions else regions
  in
  Array.fold_left cut [ region ] z.skeleton.processes

let settled c (z : Zone.t) =
  let of_cell region =
    let s = sample c z region in
    [ converted c z region (sure s (Steer.settle s.semantics s.state)).state ]
  in
  let of_region region =
    let s = sample c z region in
    if Collisions.collides s.semantics s.state then [ { z with set = region } ]
    else List.concat_map of_cell (by_laws c z (Steer.steers (model c)) region)
  in
  if is_due z.skeleton then List.concat_map of_region (Instant.cells c z) else [ z ]

(* {1 Chance} *)

type way = { source : State.t; label : Transition.label; targets : Zone.t list }
type t = Drawn of way list | Chosen of way list

let pending (z : Zone.t) = Array.exists waits z.skeleton.processes || Lots.pending z.skeleton

(* A law that gives a velocity of its own, whatever the velocity was. *)
let ignores_velocity (m : Model.t) (l : State.leaf) =
  match m.leaves.(l.leaf).law with
  | Inertial -> false
  | (Gives _ | Choose _) as law ->
    let is_velocity : Law.variable -> bool = function
      | Vx | Vy | Vz -> true
      | X | Y | Z | Wx | Wy | Wz | Mass | Time | Dt -> false
    in
    not (Law.mentions is_velocity law)

let without_old_velocities c (z : Zone.t) =
  let is_old (p : State.process) =
    match p.draw with
    | None -> false
    | Some (Drawn _) -> true
    | Some Waits -> Array.for_all (ignores_velocity (model c)) p.leaves
  in
  let still _ p = if is_old p then State.with_velocity Vec.zero p else p in
  if is_drawing z.skeleton then { z with skeleton = State.mapi still z.skeleton } else z

let draws c (z : Zone.t) region =
  let s = sample c z region in
  match Steer.next_to_draw s.semantics s.state with
  | None -> Scc_base.Bug.fail __POS__ "nobody draws"
  | Some p ->
    let of_draw (given, chance) =
      let t = sure s (Network.drawn s.semantics s.state ~before:(fun _ -> None) p (given, chance)) in
      { source = s.state; label = t.label; targets = [ converted c { z with arrived = [] } region t.target ] }
    in
    Drawn (List.map of_draw (sure s (Steer.chances s.semantics s.state p)))

let lots c ~events (z : Zone.t) region =
  let s = sample c z region in
  let due = match Lots.due (model c) s.state with Some due -> due | None -> Scc_base.Bug.fail __POS__ "no lots" in
  let of_outcome (o : Transition.outcome) =
    let step = z.skeleton.step in
    let happenings = Happening.of_outcome c ~events z region s.state ~step o in
    let targets = List.concat_map (fun (h : Happening.t) -> settled c h.target) happenings in
    { source = s.state; label = o.label; targets }
  in
  let outcomes = List.map of_outcome (sure s (Splits.lots s.semantics due)) in
  if List.for_all (fun way -> Transition.is_drawn way.label) outcomes then Drawn outcomes else Chosen outcomes

let all c ~events (z : Zone.t) =
  if Lots.pending z.skeleton then List.map (fun region -> (region, lots c ~events z region)) (Instant.cells c z)
  else
    (* Zones that differ in what they draw may have become one. *)
    List.map (fun region -> (region, draws c z region)) (by_laws c z waits z.set)
