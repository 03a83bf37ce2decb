open Scc_exact
open Scc_calculus

let at_rest which = State.mapi (fun i p -> if which i then State.with_velocity Vec.zero p else p)

(* {1 Where walkers stop} *)

(* A bond, or an absorption, comes before what else the same walker runs into. *)
let rec until_none (c : Semantics.t) (s : State.t) =
  let meetings = Collisions.meetings c s.processes in
  let may_bind = List.filter (fun m -> Collisions.candidates c s.processes m <> []) meetings in
  let is_busy i = List.exists (fun (m : Kinematics.meeting) -> m.first = i || m.second = i) may_bind in
  let stops = List.concat_map (Collisions.blocked c s.processes) meetings in
  match List.filter (fun i -> not (is_busy i)) stops with
  | [] -> s
  | stops ->
    let which = Array.make (Array.length s.processes) false in
    List.iter (fun i -> which.(i) <- true) stops;
    until_none c (at_rest (Array.get which) s)

let stopped (c : Semantics.t) s = if Model.stops_walkers c.setting.model then until_none c s else s

(* {1 Kicks that are not taken} *)

(* Two processes one of which at least has been kicked, with all of their parts that may come near each other. *)
type two = { first : int; second : int; parts : (Part.t * Part.t) list }

let speed (p : State.process) =
  let { Vec.x; y; z } = p.velocity in
  Rat.add (Rat.abs x) (Rat.add (Rat.abs y) (Rat.abs z))

let near_each_other (c : Semantics.t) ~kicked (s : State.t) =
  let fastest = Array.fold_left (fun most p -> Rat.max most (speed p)) Rat.zero s.processes in
  let margin = Rat.mul (Rat.of_int 2) (Rat.mul c.setting.model.timestep fastest) in
  let concerning ((a : Part.t), (b : Part.t)) =
    if kicked a.process || kicked b.process then Some ((), (a, b)) else None
  in
  let two pairs =
    let parts = List.map snd pairs in
    let (a : Part.t), (b : Part.t) = List.hd parts in
    { first = a.process; second = b.process; parts }
  in
  c.setting.neighbours.within margin (Collisions.parts c s.processes)
  |> List.filter_map concerning |> Collisions.by_processes |> List.map two

let first_collision (c : Semantics.t) two =
  let time ((a : Part.t), (b : Part.t)) =
    match c.setting.geometry.first_time_of_contact a.placed b.placed (Part.relative_velocity a b) with
    | Never -> None
    | At t -> Some t
    | Inside -> Scc_base.Bug.fail __POS__ "two bodies interpenetrate"
  in
  List.fold_left (fun first pair -> Option.merge Rat.min first (time pair)) None two.parts

(* By the behaviours that the two have now. *)
let binds_at c t p q =
  let model = Semantics.model c in
  let then_ = [| Turn.pass model t p; Turn.pass model t q |] in
  List.exists (fun m -> Collisions.candidates c then_ m <> []) (Collisions.meetings c then_)

let run_into_each_other (c : Semantics.t) (s : State.t) two =
  let before_the_next_draw t = Rat.compare t c.setting.model.timestep < 0 in
  match first_collision c two with
  | Some t when before_the_next_draw t -> not (binds_at c t s.processes.(two.first) s.processes.(two.second))
  | Some _ | None -> false

let sweeps_meet (c : Semantics.t) two =
  let path (a : Part.t) = Vec.scale c.setting.model.timestep (Part.velocity a) in
  let meet (a, (b : Part.t)) = c.setting.geometry.sweeps_meet a.Part.placed b.placed (path a) (path b) in
  List.exists meet two.parts

(* From those that run into something, on through all whose sweeps meet. *)
let blocked (c : Semantics.t) ~kicked (s : State.t) =
  let n = Array.length s.processes in
  let blocked = Array.make n false and neighbours = Array.make n [] in
  let pairs = near_each_other c ~kicked s in
  let rec block i =
    if kicked i && not blocked.(i) then begin
      blocked.(i) <- true;
      List.iter (fun (j, two) -> if (not blocked.(j)) && sweeps_meet c two then block j) neighbours.(i)
    end
  in
  let join two =
    if kicked two.first && kicked two.second then begin
      neighbours.(two.first) <- (two.second, two) :: neighbours.(two.first);
      neighbours.(two.second) <- (two.first, two) :: neighbours.(two.second)
    end
  in
  List.iter join pairs;
  List.iter (fun two -> if run_into_each_other c s two then (block two.first; block two.second)) pairs;
  blocked

let waiting (c : Semantics.t) ~kicked (s : State.t) =
  match c.setting.model.blocked with
  | Bounce | Stop -> s
  | Wait -> at_rest (Array.get (blocked c ~kicked s)) s
