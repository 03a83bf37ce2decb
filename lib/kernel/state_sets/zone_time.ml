open Scc_polyhedra
open Scc_offsets
open Scc_calculus
open Scc_semantics

(* {1 Delays} *)

let length (m : Model.t) : Behaviour.t -> Linear.t = function
  | Delay (t, _) -> Linear.constant (Array.length m.ranges) t
  | Wait (t, _) -> t
  | Nil | Open _ | Weak _ | Strong _ | Sum _ | Call _ -> Scc_base.Bug.fail __POS__ "no delay"

let lengths (m : Model.t) (l : State.leaf) =
  List.map (length m) (Behaviours.delays m.definitions l.behaviour)

let left (z : Zone.t) leaf length =
  Linear.sub (Linear.compose length ~dimension:(Zone.dimension z) z.parameters) z.ages.(leaf)

(* {1 Split clocks} *)

let to_split_instant m (z : Zone.t) (p : State.process) =
  let left (step, _) =
    let first = p.leaves.(0).leaf in
    (first, Linear.sub (Linear.constant (Zone.dimension z) step) z.clocks.(first))
  in
  Option.map left (Process.running_clock m p)

let to_split_instants m (z : Zone.t) =
  List.filter_map (to_split_instant m z) (Array.to_list z.skeleton.processes)

let may_split (z : Zone.t) =
  Array.exists (fun (p : State.process) -> Option.is_some p.clock) z.skeleton.processes

let splits_at_any_time m (z : Zone.t) = Array.exists (Process.splits_at_any_time m) z.skeleton.processes

(* {1 Passing} *)

let all_left m z =
  List.concat_map (fun (l : State.leaf) -> List.map (left z l.leaf) (lengths m l)) (State.leaves z.skeleton)
  @ List.map snd (to_split_instants m z)

let after m (z : Zone.t) time =
  let ages = Array.copy z.ages and clocks = Array.copy z.clocks and places = Array.copy z.places in
  let of_process (p : State.process) =
    let of_leaf (l : State.leaf) =
      places.(l.leaf) <- Place.moved places.(l.leaf) p.velocity time;
      if lengths m l <> [] then ages.(l.leaf) <- Linear.add ages.(l.leaf) time
    in
    Array.iter of_leaf p.leaves;
    let first = p.leaves.(0).leaf in
    if Option.is_some (Process.running_clock m p) then clocks.(first) <- Linear.add clocks.(first) time
  in
  Array.iter of_process z.skeleton.processes;
  let moving (s : State.step) = { s with phase = State.Moving } in
  let skeleton = State.at ~step:(Option.map moving z.skeleton.step) ~time:z.skeleton.time z.skeleton in
  let later = Option.map (Linear.add time) in
  let step = Option.map (fun left -> Linear.sub left time) z.step in
  { z with
    skeleton; arrived = []; halted = false; time = later z.time; step; grid = later z.grid; ages; clocks; places }
