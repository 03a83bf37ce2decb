(* Solids, turns and places that the properties draw from: much of it degenerate on purpose. *)

open Scc_exact
open Scc_geometry
module Naive = Scc_naive.Naive
module Gen = QCheck2.Gen

let hull points = Naive.hull (List.map (fun (x, y, z) -> Vec.of_ints x y z) points)
let signs = [ -1; 1 ]

let box x y z =
  let corner a b c = (a * x, b * y, c * z) in
  hull (List.concat_map (fun a -> List.concat_map (fun b -> List.map (corner a b) signs) signs) signs)

let cube = box 1 1 1
let slab = box 2 1 1
let tetrahedron = hull [ (0, 0, 0); (2, 0, 0); (0, 2, 0); (0, 0, 2) ]
let octahedron = hull [ (1, 0, 0); (-1, 0, 0); (0, 1, 0); (0, -1, 0); (0, 0, 1); (0, 0, -1) ]
let prism = hull [ (-1, -1, -1); (1, -1, -1); (0, 1, -1); (-1, -1, 1); (1, -1, 1); (0, 1, 1) ]

(* 14 vertices, 12 rhombi. *)
let rhombic =
  hull
    ((List.concat_map (fun s -> [ (2 * s, 0, 0); (0, 2 * s, 0); (0, 0, 2 * s) ]) signs)
     @ List.concat_map (fun x -> List.concat_map (fun y -> List.map (fun z -> (x, y, z)) signs) signs) signs)

let plank = box 8 2 1
let needle = hull [ (0, 0, 0); (9, 0, 0); (9, 1, 0); (8, 0, 1) ]
let sliver = hull [ (0, 0, 0); (9, 0, 1); (9, 9, 0); (0, 9, 1) ]

(* Nine vertices, of which some are nearly in one plane. *)
let lump =
  hull
    [ (3, 0, 0); (-3, 1, 0); (0, 3, 1); (1, -3, 0); (0, 1, 3); (1, 0, -3); (2, 2, 2); (-2, -2, 2); (2, 1, -2) ]

let named =
  [ ("plank", plank); ("needle", needle); ("sliver", sliver); ("lump", lump); ("cube", cube); ("slab", slab);
    ("tetrahedron", tetrahedron); ("octahedron", octahedron); ("prism", prism);
    ("rhombic dodecahedron", rhombic) ]

let quaternion (w, x, y, z) =
  let q = Rat.of_int in
  match Mat.of_quaternion (q w, q x, q y, q z) with Some m -> m | None -> Mat.identity

(* Rotations of the cube onto itself, 24 of them. *)
let cube_turns =
  let v = Vec.of_ints in
  let axes = [ v 1 0 0; v (-1) 0 0; v 0 1 0; v 0 (-1) 0; v 0 0 1; v 0 0 (-1) ] in
  let right_handed a =
    let turn b = if Rat.sign (Vec.dot a b) = 0 then Some (Mat.make a b (Vec.cross a b)) else None in
    List.filter_map turn axes
  in
  List.concat_map right_handed axes

(* A body: a solid, turned. *)
type body = { name : string; plain : Naive.solid; turn : Mat.t }

let any_turn =
  let c = Gen.(-3 -- 3) in
  Gen.map quaternion (Gen.quad c c c c)

let about_z = Gen.map (fun (w, z) -> quaternion (w, 0, 0, z)) Gen.(pair (-3 -- 3) (-3 -- 3))

(* Mostly turns that keep edges and faces parallel. *)
let turn = Gen.frequency [ (3, Gen.oneofl cube_turns); (2, about_z); (2, any_turn) ]
let body = Gen.map2 (fun (name, plain) turn -> { name; plain; turn }) (Gen.oneofl named) turn
let half n = Rat.make (Z.of_int n) (Z.of_int 2)
let halves (x, y, z) = Vec.make (half x) (half y) (half z)
let offset = Gen.map halves Gen.(triple (-6 -- 6) (-6 -- 6) (-6 -- 6))
let velocity = Gen.map halves Gen.(triple (-3 -- 3) (-3 -- 3) (-3 -- 3))
let solid ~id b = Scc_test_data.Test_data.solid ~id b.plain b.turn
let placed b at = Naive.move b.turn at b.plain
let obstacle a b = Obstacle.make (solid ~id:0 a) (solid ~id:1 b)

let equal_cast (x : Obstacle.cast) (y : Obstacle.cast) =
  match (x, y) with
  | Never, Never | Inside, Inside -> true
  | At s, At t -> Rat.equal s t
  | _ -> false

let same_interval x y =
  let same (a, b) (c, d) = Option.equal Rat.equal a c && Option.equal Rat.equal b d in
  Option.equal same x y

type scene = { a : body; b : body; r : Vec.t; w : Vec.t }

let scene = Gen.map2 (fun (a, b) (r, w) -> { a; b; r; w }) (Gen.pair body body) (Gen.pair offset velocity)

let show s =
  let m (t : Mat.t) = String.concat "" (List.map Vec.to_string [ t.r0; t.r1; t.r2 ]) in
  Printf.sprintf "%s %s, %s %s, offset %s, velocity %s" s.a.name (m s.a.turn) s.b.name (m s.b.turn)
    (Vec.to_string s.r) (Vec.to_string s.w)

(* Two points of a random line through both bodies, so that most scenes drawn this way collide. *)
let aimed =
  let far (x, y, z) = Vec.of_ints (2 * x) (2 * y) (2 * z) in
  let aim s (r, past) = { s with r = far r; w = Vec.sub (halves past) (far r) } in
  Gen.map2 aim scene Gen.(pair (triple (-3 -- 3) (-3 -- 3) (-3 -- 3)) (triple (-2 -- 2) (-2 -- 2) (-2 -- 2)))

(* Aligned bodies on a grid, which touch as they stand about as often as not. *)
let resting =
  let make (name, plain) turn = { name; plain; turn } in
  let axis_aligned = Gen.map2 make (Gen.oneofl named) (Gen.oneofl cube_turns) in
  let offset =
    Gen.map2 (fun (x, y) axis -> (x, y, axis)) Gen.(pair (-5 -- 5) (-5 -- 5)) (Gen.oneofl cube_turns)
  in
  Gen.map2
    (fun (a, b) (x, y, m) ->
       let level = Vec.make (half x) (half y) (Rat.of_int 2) in
       { a; b; r = Mat.apply m level; w = Mat.apply m (Vec.of_ints 0 0 (-1)) })
    (Gen.pair axis_aligned axis_aligned) offset

(* Where the bodies of a scene touch and approach, if they ever collide. *)
let collision s =
  let o = obstacle s.a s.b in
  match Obstacle.first_time_of_contact o s.r s.w with
  | Obstacle.At t -> Some (o, Vec.axpy t s.w s.r)
  | Never | Inside -> None

let property ?(count = 200) ?(gen = scene) name f = QCheck2.Test.make ~name ~count ~print:show gen f
