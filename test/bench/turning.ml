(* Times the cast of turning solids:

     turning.exe [SHAPE ...]      nanoseconds for each query (cube.txt and poly50.txt of test/data/geometry)

   Two solids of one shape, about two of their radii wide, turn as far as a step allows while B flies past A: 'far'
   always at a good distance; 'aimed' at A, so that most of them collide; 'near' so that many miss. *)

open Scc_exact
open Scc_geometry
open Scc_rigid
module Data = Scc_test_data.Test_data

let one_in = Q.of_ints 1

(* A generator that is the same everywhere. *)
let seed = ref 1

let next bound =
  seed := ((!seed * 25214903917) + 11) land ((1 lsl 48) - 1);
  (!seed lsr 17) mod bound

let between low high = low + next (high - low + 1)
let vector top = Vec.of_ints (between (-top) top) (between (-top) top) (between (-top) top)
let int v = Z.of_int v

let quaternion () =
  Quaternion.make (int (1 + next 99)) (int (between (-99) 99)) (int (between (-99) 99)) (int (between (-99) 99))

(* Up to a length of a half: the step lasts 1. *)
let spin () = Vec.scale (one_in 3600) (vector 1000)

(* Turning about its centroid. *)
let motion (solid : Solid.t) centre velocity : Motion.t =
  let turned = quaternion () in
  let arm = Vec.neg (Quaternion.apply turned solid.centroid) in
  { solid; turned; arm; centre; velocity; spin = spin (); since = Rat.zero }

type kind = Far | Aimed | Near

(* B starts 2.5 radii away and goes 3 radii: towards A, but for a displacement to the side. *)
let pair kind a b =
  let radius = Q.to_float a.Solid.radius in
  let direction = vector 1000 in
  let length = sqrt (Rat.to_float (Vec.norm2 direction)) in
  let side = Vec.cross direction (vector 1000) in
  let wide = sqrt (Rat.to_float (Vec.norm2 side)) in
  let times x v = Vec.scale (Rat.round_to (Q.of_float x) ~quantum:(one_in 1048576)) v in
  let aside k = times (k *. radius /. wide) side in
  let start = times (2.5 *. radius /. length) direction and path = times (-3. *. radius /. length) direction in
  let k = float_of_int (next 1000) /. 1000. in
  let shift = aside (match kind with Far -> 3. +. k | Aimed -> 0.8 *. k | Near -> 1.2 +. (0.8 *. k)) in
  (motion a Vec.zero Vec.zero, motion b (Vec.add start shift) path)

let repeat = 200
let count = 1000

let time name shape kind =
  let solid id = Data.solid ~id (Data.shape shape) Mat.identity in
  let a = solid 0 and b = solid 1 in
  let pairs = Array.init count (fun _ -> pair kind a b) in
  let grid (a, b) = Cast.grid a b ~resolution:(Rat.mul a.Motion.solid.radius (one_in 1048576)) in
  let grids = Array.map grid pairs in
  let hits = ref 0 and exact = ref 0 in
  let ask i =
    let a, b = pairs.(i) in
    match Cast.first_time_of_contact a b ~span:Rat.one ~grid:grids.(i) with
    | At _ -> incr hits
    | Never | Inside -> ()
    | exception _ -> incr exact
  in
  let start = Sys.time () in
  for _ = 1 to repeat do
    hits := 0;
    exact := 0;
    for i = 0 to count - 1 do
      ask i
    done
  done;
  let ns = (Sys.time () -. start) *. 1e9 /. float_of_int (repeat * count) in
  let start = Sys.time () in
  for _ = 1 to 10 do
    Array.iter (fun pair -> ignore (grid pair)) pairs
  done;
  let for_grid = (Sys.time () -. start) *. 1e9 /. float_of_int (10 * count) in
  Printf.printf "%-40s %-6s %8.0f ns   %d of %d collide (%d); %.0f ns for the grid\n%!" name
    (match kind with Far -> "far" | Aimed -> "aimed" | Near -> "near")
    ns !hits count !exact for_grid

(* Neither turns nor has turned: against the cast that knows no turns, each with the obstacle made before. *)
let time_straight name shape =
  let solid id = Data.solid ~id (Data.shape shape) Mat.identity in
  let a = solid 0 and b = solid 1 in
  let still (m : Motion.t) = { m with turned = Quaternion.identity; arm = Vec.zero; spin = Vec.zero } in
  let one _ =
    let a, b = pair Aimed a b in
    let a = still a and b = still b in
    let resolution = Rat.mul a.solid.radius (one_in 1048576) in
    (a, b, Cast.grid a b ~resolution)
  in
  let pairs = Array.init count one in
  let obstacle = Obstacle.make a b in
  let clock ask =
    let start = Sys.time () in
    for _ = 1 to repeat do
      Array.iter ask pairs
    done;
    (Sys.time () -. start) *. 1e9 /. float_of_int (repeat * count)
  in
  let turning (a, b, grid) =
    ignore (Cast.first_time_of_contact ~obstacle a b ~span:Rat.one ~grid : Cast.outcome)
  in
  let plain ((a : Motion.t), (b : Motion.t), _) =
    let offset = Vec.sub b.centre a.centre and velocity = Vec.sub b.velocity a.velocity in
    ignore (Obstacle.first_time_of_contact obstacle offset velocity : Obstacle.cast)
  in
  let plain = clock plain in
  Printf.printf "%-40s no turns %.0f ns; %.0f ns without motions\n%!" name (clock turning) plain

let () =
  let shapes =
    match List.tl (Array.to_list Sys.argv) with
    | [] -> [ "test/data/geometry/cube.txt"; "test/data/geometry/poly50.txt" ]
    | shapes -> shapes
  in
  List.iter
    (fun shape ->
       List.iter (time shape shape) [ Far; Aimed; Near ];
       time_straight shape shape)
    shapes
