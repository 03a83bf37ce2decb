open Scc_exact
open Scc_geometry
module Naive = Scc_naive.Naive

type shape = { name : string; plain : Naive.solid; polyhedron : Polyhedron.t }
type body = { shape : shape; linear : Mat.t }
type t = { small : shape array; large : shape array }

let corners s = Array.length s.plain.points

let shape name points =
  let plain = Naive.hull points in
  { name; plain; polyhedron = (Scc_test_data.Test_data.solid ~id:0 plain Mat.identity).polyhedron }

let vectors = List.map (fun (x, y, z) -> Vec.of_ints x y z)
let signs = [ -1; 1 ]
let each xs f = List.concat_map f xs
let of_ints name points = shape name (vectors points)

let box name x y z =
  of_ints name (each signs (fun a -> each signs (fun b -> List.map (fun c -> (a * x, b * y, c * z)) signs)))

(* {1 The fixed shapes} *)

(* A polygon at two heights; the upper one rises by 1 for each [run] along x. *)
let prism ?(run = max_int) name height polygon =
  of_ints name (each polygon (fun (x, y) -> [ (x, y, -height); (x, y, height + (x / run)) ]))

let hexagon r = [ (2 * r, 0); (r, 2 * r); (-r, 2 * r); (-2 * r, 0); (-r, -2 * r); (r, -2 * r) ]
let square r = [ (r, r); (-r, r); (-r, -r); (r, -r) ]

(* Its faces that were parallel differ by an angle of about 10^-6. *)
let bent_cube =
  let bend (x, y, z) = (x * 1_000_000 + y, y * 1_000_000 + z, z * 1_000_000 + x) in
  of_ints "almost a cube"
    (each signs (fun a -> each signs (fun b -> List.map (fun c -> bend (a, b, c)) signs)))

let octahedron x y z = [ (x, 0, 0); (-x, 0, 0); (0, y, 0); (0, -y, 0); (0, 0, z); (0, 0, -z) ]
let cube_corners = each signs (fun a -> each signs (fun b -> List.map (fun c -> (a, b, c)) signs))

let fixed () =
  [ box "cube" 1 1 1; box "cube" 1 1 1; box "cube of 1000" 500 500 500; box "plank" 100 10 1;
    box "slab" 50 50 1; box "needle box" 1 1 1000; box "very flat plank" 1_000_000 1000 1;
    of_ints "tetrahedron" [ (0, 0, 0); (2, 0, 0); (0, 2, 0); (0, 0, 2) ];
    of_ints "regular tetrahedron" [ (1, 1, 1); (1, -1, -1); (-1, 1, -1); (-1, -1, 1) ];
    of_ints "needle tetrahedron" [ (0, 0, 0); (1000, 0, 0); (1000, 1, 0); (999, 0, 1) ];
    of_ints "sliver" [ (0, 0, 0); (1000, 0, 1); (1000, 1000, 0); (0, 1000, 1) ];
    of_ints "hair" [ (0, 0, 0); (1_000_000, 1, 0); (0, 1, 0); (1_000_000, 0, 1) ];
    of_ints "octahedron" (octahedron 1 1 1); of_ints "long octahedron" (octahedron 1 2 300);
    of_ints "rhombic dodecahedron" (octahedron 2 2 2 @ cube_corners);
    of_ints "pyramid" ((0, 0, 3) :: List.map (fun (x, y) -> (x, y, 0)) (square 2));
    prism "triangular prism" 1 [ (-1, -1); (1, -1); (0, 1) ]; prism "hexagonal prism" 1 (hexagon 1);
    prism "long hexagonal prism" 200 (hexagon 1); prism "wedge" 3 ~run:2 (square 2);
    prism "very blunt wedge" 1_000_000 ~run:1_000_000 (hexagon 1_000_000);
    prism "very flat wedge" 2 ~run:1_000_000 (square 1_000_000);
    bent_cube;
    of_ints "cube far off its reference point"
      (let far = 100_000_000_000_000_000 in
       List.map (fun (x, y, z) -> (far + 7 + x, y - (3 * far) - 5, far + z)) cube_corners);
    of_ints "cube off its reference point" (List.map (fun (x, y, z) -> (100 + x, y - 50, z + 7)) cube_corners) ]

(* {1 Hulls} *)

(* Directions spread over the sphere by chance, on integer points near the sphere of radius 1000. *)
let hull g n =
  let rec point () =
    let x = Rng.range g (-1000) 1000 in
    let y = Rng.range g (-1000) 1000 in
    let z = Rng.range g (-1000) 1000 in
    let length = sqrt (float_of_int ((x * x) + (y * y) + (z * z))) in
    if length < 300. || length > 1000. then point ()
    else
      let out c = int_of_float (Float.round (1000. *. float_of_int c /. length)) in
      (out x, out y, out z)
  in
  of_ints (Printf.sprintf "hull of %d" n) (List.init n (fun _ -> point ()))

(* Many parallel edges and faces of many corners. *)
let grid_hull g n =
  let point _ =
    let x = Rng.range g (-3) 3 in
    let y = Rng.range g (-3) 3 in
    (x, y, Rng.range g (-3) 3)
  in
  of_ints "hull on a grid" ([ (0, 0, 0); (1, 0, 0); (0, 1, 0); (0, 0, 1) ] @ List.init n point)

let make g ~hulls =
  let small, large = List.partition (fun s -> corners s <= 14) (List.map (hull g) hulls) in
  let grids = List.init 4 (fun i -> grid_hull g (4 + (3 * i))) in
  { small = Array.of_list (fixed () @ small @ grids); large = Array.of_list large }

(* {1 Linear maps} *)

let quaternion w x y z =
  match Mat.of_quaternion (w, x, y, z) with Some m -> m | None -> Mat.identity

let cube_turns =
  let v = Vec.of_ints in
  let axes = [ v 1 0 0; v (-1) 0 0; v 0 1 0; v 0 (-1) 0; v 0 0 1; v 0 0 (-1) ] in
  let with_first a =
    let with_second b =
      if Rat.sign (Vec.dot a b) = 0 then Some (Mat.make a b (Vec.cross a b)) else None
    in
    List.filter_map with_second axes
  in
  Array.of_list (List.concat_map with_first axes)

let integer_quaternion g n =
  let c () = Rat.of_int (Rng.range g (-n) n) in
  let w = c () in
  let x = c () in
  let y = c () in
  quaternion w x y (c ())

(* A rotation by a very small angle. *)
let small_turn g =
  let w = Rat.make (Z.pow (Z.of_int 10) (Rng.range g 3 18)) Z.one in
  let c () = Rat.of_int (Rng.range g 0 1) in
  let x = c () in
  let y = c () in
  quaternion w x y (c ())

(* Normals of up to 1 100 bits, most of them about as long as the greatest float. *)
let long_turn g =
  let bits = if Rng.chance g 3 then Rng.range g 30 470 else Rng.range g 470 520 in
  let c () = Rat.make (Rng.positive g bits) Z.one in
  let w = c () in
  let x = c () in
  let y = c () in
  quaternion w x (Rat.neg y) (c ())

let turn g =
  match if Rng.chance g 60 then -1 else Rng.below g 8 with
  | -1 -> long_turn g
  | 0 -> Mat.identity
  | 1 | 2 -> Rng.choose g cube_turns
  | 3 -> small_turn g
  | 4 | 5 -> integer_quaternion g 4
  | 6 -> integer_quaternion g 100
  | _ -> integer_quaternion g 1_000_000_000

let power_of_ten g n =
  let k = Rng.range g (-n) n in
  let p = Z.pow (Z.of_int 10) (Int.abs k) in
  if k < 0 then Rat.make Z.one p else Rat.make p Z.one

(* Sizes, mostly 1; and now and then shapes that are stretched along one axis. *)
let size g =
  match Rng.below g 12 with
  | 0 ->
    let numerator = Rng.positive g 10 in
    Mat.scale (Rat.make numerator (Rng.positive g 10)) Mat.identity
  | 1 -> Mat.scale (power_of_ten g 3) Mat.identity
  | 2 -> Mat.scale (power_of_ten g (if Rng.chance g 4 then 150 else 40)) Mat.identity
  | 3 ->
    let y = power_of_ten g 2 in
    Mat.diagonal (Vec.make Rat.one y (Rat.make (Rng.positive g 6) Z.one))
  | _ -> Mat.identity

let pick shapes g =
  if Array.length shapes.large > 0 && Rng.chance g 40 then Rng.choose g shapes.large
  else Rng.choose g shapes.small

let pair shapes g =
  let common = if Rng.chance g 3 then turn g else Mat.identity in
  let size_of_both = size g in
  let first = pick shapes g in
  let second = if Rng.chance g 3 then first else pick shapes g in
  let turned () = if Rng.chance g 3 then common else Mat.mul common (turn g) in
  let sized m = if Rng.chance g 8 then Mat.mul m (size g) else Mat.mul m size_of_both in
  let a = sized (turned ()) in
  ({ shape = first; linear = a }, { shape = second; linear = sized (turned ()) })

let place b = Naive.move b.linear Vec.zero b.shape.plain

let show b =
  let rows (m : Mat.t) = String.concat " " (List.map Vec.to_string [ m.r0; m.r1; m.r2 ]) in
  let points = Array.to_list (Array.map Vec.to_string b.shape.plain.points) in
  Printf.sprintf "%s, hull of %s\n    under the rows %s" b.shape.name (String.concat " " points)
    (rows b.linear)
