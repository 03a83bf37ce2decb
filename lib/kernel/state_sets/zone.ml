open Scc_exact
open Scc_polyhedra
open Scc_offsets
open Scc_calculus

type t = {
  skeleton : State.t;
  halted : bool;
  arrived : int list;
  set : Polyhedron.t;
  parameters : Linear.t array;
  time : Linear.t option;
  step : Linear.t option;
  grid : Linear.t option;
  ages : Linear.t array;
  clocks : Linear.t array;
  places : Place.t array;
  basis : int array;
}

(* {1 Making} *)

(* With these numbers: of the movement step, of lots, of the split clock of a process, of a leaf. *)
let with_numbers ~remaining ~since ~clock ~leaf s =
  let process (p : State.process) =
    State.map_leaves leaf p
    |> State.with_clock (Option.map (fun _ -> clock p) p.clock)
    |> State.with_lots (Option.map (fun (l : State.lots) -> { l with since }) p.lots)
  in
  let step = Option.map (fun (s : State.step) -> { s with remaining }) s.State.step in
  State.at ~step ~time:s.time (State.mapi (fun _ -> process) s)

let skeleton s =
  let leaf (l : State.leaf) = { l with position = Vec.zero } in
  with_numbers ~remaining:Rat.zero ~since:Rat.zero ~clock:(fun _ -> Rat.zero) ~leaf s

let declared (m : Model.t) (u : Uncertain.t) (s : State.t) ~keeps_time =
  let n = Array.length m.ranges in
  let zero = Linear.constant n Rat.zero in
  let place leaf p = if Option.is_some (State.home s leaf) then p else Place.constant n Vec.zero in
  {
    skeleton = skeleton (State.at ~step:s.step ~time:None s);
    halted = false;
    arrived = [];
    set = Ranges.box m.ranges;
    parameters = Array.init n (Linear.variable n);
    time = (if keeps_time then Some zero else None);
    step = Option.map (fun (s : State.step) -> Linear.constant n s.remaining) s.step;
    grid = (if m.lots then Some zero else None);
    ages = Array.map (fun _ -> zero) m.leaves;
    clocks = Array.map (fun _ -> zero) m.leaves;
    places = Array.mapi place u.places;
    basis = [||];
  }

(* {1 Coordinates} *)

let dimension z = Polyhedron.dimension z.set

let coordinates z =
  let places = List.concat_map Place.coordinates (Array.to_list z.places) in
  let times = List.concat_map Option.to_list [ z.time; z.step; z.grid ] in
  Array.concat [ z.parameters; Array.of_list times; z.ages; z.clocks; Array.of_list places ]

let map f z =
  {
    z with
    parameters = Array.map f z.parameters;
    time = Option.map f z.time;
    step = Option.map f z.step;
    grid = Option.map f z.grid;
    ages = Array.map f z.ages;
    clocks = Array.map f z.clocks;
    places = Array.map (Place.map f) z.places;
  }

let place z leaf (part : Model.part) =
  let offset =
    match part.open_offset with
    | None -> Place.constant (dimension z) part.offset
    | Some forms -> Place.compose forms ~dimension:(dimension z) z.parameters
  in
  Place.add z.places.(leaf) offset

let with_variables z ~dimension forms set =
  { (map (fun f -> Linear.compose f ~dimension forms) z) with set }

let earliest z =
  let of_form form = Polyhedron.limit (Polyhedron.infimum z.set form) in
  Option.bind z.time of_form

let values z point = Array.map (fun f -> Linear.eval f point) z.parameters

let at z point =
  let some form = match form with Some f -> Linear.eval f point | None -> Rat.zero in
  let leaf (l : State.leaf) = { l with State.position = Place.eval z.places.(l.leaf) point } in
  let clock (p : State.process) = Linear.eval z.clocks.(p.leaves.(0).leaf) point in
  with_numbers ~remaining:(some z.step) ~since:(some z.grid) ~clock ~leaf z.skeleton
