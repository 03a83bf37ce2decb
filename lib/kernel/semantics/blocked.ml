open Scc_exact
open Scc_calculus

module Ids = Set.Make (Int)
module By_process = Map.Make (Int)

let at_rest which = State.mapi (fun i p -> if Ids.mem i which then State.with_velocity Vec.zero p else p)

(* {1 Where walkers stop} *)

(* A bond, or an absorption, comes before what else the same walker runs into. *)
let to_stop (c : Semantics.t) processes =
  let meetings = Collisions.meetings c processes in
  let busy = List.filter (fun m -> Collisions.candidates c processes m <> []) meetings in
  let busy = Ids.of_list (List.concat_map (fun (m : Kinematics.meeting) -> [ m.first; m.second ]) busy) in
  Ids.diff (Ids.of_list (List.concat_map (Collisions.blocked c processes) meetings)) busy

let rec until_none (c : Semantics.t) (s : State.t) =
  let stops = to_stop c s.processes in
  if Ids.is_empty stops then s else until_none c (at_rest stops s)

let stopping c processes = List.map (fun i -> processes.(i)) (Ids.elements (to_stop c processes))

let stopped (c : Semantics.t) s = if Model.stops_walkers c.setting.model then until_none c s else s

(* {1 Kicks that are not taken} *)

(* Two processes one of which at least has been kicked, with all of their parts that may come near each other. *)
type two = { first : int; second : int; parts : (Part.t * Part.t) list }

let near_each_other (c : Semantics.t) ~kicked (s : State.t) =
  let concerning ((a : Part.t), (b : Part.t)) =
    if kicked a.process || kicked b.process then Some ((), (a, b)) else None
  in
  let two pairs =
    let parts = List.map snd pairs in
    let (a : Part.t), (b : Part.t) = List.hd parts in
    { first = a.process; second = b.process; parts }
  in
  c.setting.neighbours.along c.setting.model.timestep (Collisions.parts c s.processes)
  |> List.filter_map concerning |> Collisions.by_processes |> List.map two

let paths (c : Semantics.t) ((a : Part.t), (b : Part.t)) =
  let { Kinematics.model; geometry; _ } = c.setting in
  geometry.paths a.placed b.placed ~span:model.timestep (Part.velocity a) (Part.velocity b)

let first_collision (c : Semantics.t) two =
  let time pair =
    match (paths c pair).contact with
    | Never -> None
    | At t -> Some t
    | Inside -> Scc_base.Bug.fail __POS__ "two bodies interpenetrate"
  in
  List.fold_left (fun first pair -> Option.merge Rat.min first (time pair)) None two.parts

(* By the behaviours that the two have now. *)
let binds_at c t p q =
  Collisions.may_react c p q
  &&
  let model = Semantics.model c in
  let then_ = [| Turn.pass model t p; Turn.pass model t q |] in
  List.exists (fun m -> Collisions.candidates c then_ m <> []) (Collisions.meetings c then_)

let run_into_each_other (c : Semantics.t) (s : State.t) two =
  let before_the_next_draw t = Rat.compare t c.setting.model.timestep < 0 in
  match first_collision c two with
  | Some t when before_the_next_draw t -> not (binds_at c t s.processes.(two.first) s.processes.(two.second))
  | Some _ | None -> false

let sweeps_meet c two = List.exists (fun pair -> Lazy.force (paths c pair).sweeps_meet) two.parts

type together = { blocks : bool; sweeps : bool; undisturbed : bool }

(* Where both move, one may be stopped at the end by a third, so that the other one runs into it. *)
let may_react_at_end (c : Semantics.t) (s : State.t) two =
  let model = Semantics.model c in
  let p = s.processes.(0) and q = s.processes.(1) in
  let d = model.timestep in
  if Vec.is_zero p.velocity || Vec.is_zero q.velocity then binds_at c d p q
  else
    let then_ = [| Turn.pass model d p; Turn.pass model d q |] in
    let at_end (part : Part.t) =
      let moved = Vec.axpy d (Part.velocity part) part.placed.at in
      { part with owner = then_.(part.process); placed = { part.placed with at = moved } }
    in
    let touch ((a : Part.t), (b : Part.t)) =
      match c.setting.geometry.relation a.placed b.placed with Touching -> true | Apart | Interpenetrating -> false
    in
    let touching = List.filter touch (List.map (fun (a, b) -> (at_end a, at_end b)) two.parts) in
    touching <> []
    && Collisions.candidates c then_ { Kinematics.first = 0; second = 1; collide = true; touching } <> []

let together (c : Semantics.t) p q =
  let s = State.make ~processes:[ p; q ] ~step:None ~time:None in
  let of_process i (part : Part.t) = Int.equal part.process i in
  let parts = Array.to_list (Collisions.parts c s.processes) in
  let ones = List.filter (of_process 0) parts and others = List.filter (of_process 1) parts in
  let two = { first = 0; second = 1; parts = List.concat_map (fun a -> List.map (fun b -> (a, b)) others) ones } in
  let overlap ((a : Part.t), (b : Part.t)) =
    match c.setting.geometry.relation a.placed b.placed with Interpenetrating -> true | Apart | Touching -> false
  in
  if List.exists overlap two.parts then { blocks = true; sweeps = true; undisturbed = false }
  else
    let in_time = match first_collision c two with
      | Some t -> Rat.compare t c.setting.model.timestep < 0
      | None -> false
    in
    let undisturbed = not (in_time || may_react_at_end c s two) in
    { blocks = run_into_each_other c s two; sweeps = sweeps_meet c two; undisturbed }

(* From those that run into something, on through all whose sweeps meet. *)
let rec spread ~beside blocked = function
  | [] -> blocked
  | i :: rest when Ids.mem i blocked -> spread ~beside blocked rest
  | i :: rest ->
    let more = beside i (fun j -> not (Ids.mem j blocked)) in
    spread ~beside (Ids.add i blocked) (List.rev_append more rest)

let blocked (c : Semantics.t) ~kicked (s : State.t) =
  let pairs = near_each_other c ~kicked s in
  let add i other = By_process.update i (fun others -> Some (other :: Option.value others ~default:[])) in
  let join near two = near |> add two.first (two.second, two) |> add two.second (two.first, two) in
  let of_kicks = List.filter (fun two -> kicked two.first && kicked two.second) pairs in
  let near = List.fold_left join By_process.empty of_kicks in
  let beside i which =
    Option.value (By_process.find_opt i near) ~default:[]
    |> List.filter_map (fun (j, two) -> if which j && sweeps_meet c two then Some j else None)
  in
  List.filter (run_into_each_other c s) pairs
  |> List.concat_map (fun two -> List.filter kicked [ two.first; two.second ])
  |> spread ~beside Ids.empty

let waiting (c : Semantics.t) ~kicked (s : State.t) =
  match c.setting.model.blocked with
  | Bounce | Stop -> s
  | Wait -> at_rest (blocked c ~kicked s) s
