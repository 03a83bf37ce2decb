open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_runs

type shapes = Cubes | Turned | Mixed

type body = {
  position : Vec.t;
  velocity : Vec.t;
  half_size : Rat.t;
  mass : Rat.t;
  turn : int * int * int * int;
}

type t = { side : int; bodies : body array }

let ratio n d = Rat.make (Z.of_int n) (Z.of_int d)

(* One body in each of [count] cells of a cubic grid, spread over it evenly. A body turned anyhow reaches at most
   7/8 from its centre, and the centre is at most 1/2 from that of its cell: the cells hold their bodies. *)
let spacing = 3

let cells_per_side count =
  let rec from k = if k * k * k >= count then k else from (k + 1) in
  from 1

let turns =
  [| (1, 0, 0, 0); (2, 1, 0, 0); (3, 1, -1, 1); (2, 0, 1, 1); (3, 0, 2, -1); (1, 1, 2, 0) |]

let three draw = Vec.make (draw ()) (draw ()) (draw ())

let make shapes ~count ~seed =
  let generator = ref (Splitmix64.of_seed seed) in
  let below n =
    let k, next = Splitmix64.below n !generator in
    generator := next;
    k
  in
  let symmetric n d = ratio (below ((2 * n) + 1) - n) d in
  let k = cells_per_side count in
  let body i =
    let cell = i * (k * k * k) / count in
    let middle c = ratio ((2 * spacing * c) + spacing) 2 in
    let centre = Vec.make (middle (cell mod k)) (middle (cell / k mod k)) (middle (cell / (k * k))) in
    let position = Vec.add centre (three (fun () -> symmetric 512 1024)) in
    let velocity = three (fun () -> symmetric 256 256) in
    let size, turn =
      match shapes with
      | Cubes -> (4, turns.(0))
      | Turned -> (4, turns.(below 6))
      | Mixed -> (2 + below 3, turns.(below 4))
    in
    { position; velocity; half_size = ratio size 8; mass = ratio (size * size * size) 64; turn }
  in
  { side = spacing * k; bodies = Array.init count body }

(* {1 As a network} *)

let cube = Scc_test_networks.Cube.polyhedron

let rotation (w, x, y, z) =
  match Mat.of_quaternion (Rat.of_int w, Rat.of_int x, Rat.of_int y, Rat.of_int z) with
  | Some r -> r
  | None -> failwith "the zero quaternion"

let leaf name solid mass ~fixed : Model.leaf =
  let part : Model.part = { name; template = "Cube"; solid; offset = Vec.zero; open_offset = None; mass } in
  {
    name; template = "Cube"; parts = [| part |]; fixed; absorbs = false; mass; law = Inertial;
    law_at = Scc_base.Span.none;
  }

(* Slabs that touch one another: centres and half sizes. *)
let walls side =
  let thick = 3 in
  let half = ratio side 2 and out = ratio thick 2 in
  let far = Rat.add (Rat.of_int side) out and near = Rat.neg out in
  let whole = Rat.add half (Rat.of_int thick) in
  [
    (Vec.make near half half, Vec.make out whole whole);
    (Vec.make far half half, Vec.make out whole whole);
    (Vec.make half near half, Vec.make half out whole);
    (Vec.make half far half, Vec.make half out whole);
    (Vec.make half half near, Vec.make half half out);
    (Vec.make half half far, Vec.make half half out);
  ]

let network t =
  let solids = ref [] in
  let solid linear =
    match List.find_opt (fun (s : Solid.t) -> Mat.equal s.linear linear) !solids with
    | Some s -> s
    | None ->
      let s = Solid.make ~id:(List.length !solids) cube linear in
      solids := s :: !solids;
      s
  in
  let place i position velocity =
    let behaviour = Behaviour.fresh Behaviour.nil in
    let leaf : State.leaf = { leaf = i; position; turned = Quaternion.identity; waited = Rat.zero; behaviour } in
    State.process ~leaves:[ leaf ] ~bonds:[] ~velocity ~clock:None ()
  in
  let n = Array.length t.bodies in
  let of_body i b =
    ( leaf (Printf.sprintf "b%d" i) (solid (Mat.scale b.half_size (rotation b.turn))) b.mass ~fixed:false,
      place i b.position b.velocity )
  in
  let of_wall i (centre, half) =
    ( leaf (Printf.sprintf "w%d" (i + 1)) (solid (Mat.diagonal half)) Rat.one ~fixed:true,
      place (n + i) centre Vec.zero )
  in
  let all = Array.append (Array.mapi of_body t.bodies) (Array.of_list (List.mapi of_wall (walls t.side))) in
  let m : Model.t =
    {
      leaves = Array.map fst all;
      definitions = [||];
      timestep = Rat.one;
      splits = Every Rat.one;
      ranges = [||];
      keeps_time = false;
      collisions = In_turn;
      binding = On_collision;
      bonds = Acyclic;
      blocked = Bounce;
      round_velocity = None;
      lots = false;
      rigid = None;
      steered = false;
      steps = Shared;
    }
  in
  (m, State.make ~processes:(Array.to_list (Array.map snd all)) ~step:None ~time:None)

let write channel t ~time =
  let text = Rat.to_string in
  let vec (v : Vec.t) = String.concat " " (List.map text [ v.x; v.y; v.z ]) in
  Printf.fprintf channel "%d %d %s\n" (Array.length t.bodies) t.side (text time);
  Array.iter
    (fun b ->
       let w, x, y, z = b.turn in
       Printf.fprintf channel "%s %s %s %s %d %d %d %d\n" (vec b.position) (vec b.velocity) (text b.half_size)
         (text b.mass) w x y z)
    t.bodies
