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
  ages : Linear.t array;
  clocks : Linear.t array;
  places : Place.t array;
  basis : int array;
}

let dimension z = Polyhedron.dimension z.set

let coordinates z =
  let places = List.concat_map Place.coordinates (Array.to_list z.places) in
  Array.concat [ z.parameters; Array.of_list (Option.to_list z.time); z.ages; z.clocks; Array.of_list places ]

let map f z =
  {
    z with
    parameters = Array.map f z.parameters;
    time = Option.map f z.time;
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

let at z point =
  let leaf (l : State.leaf) = { l with State.position = Place.eval z.places.(l.leaf) point } in
  let process (p : State.process) =
    let clock = Option.map (fun _ -> Linear.eval z.clocks.(p.leaves.(0).leaf) point) p.clock in
    State.with_clock clock (State.map_leaves leaf p)
  in
  State.mapi (fun _ -> process) z.skeleton
