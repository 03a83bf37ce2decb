open Scc_exact
open Scc_geometry

type side = Inscribed | Circumscribed
type t = { corners : int; factor : Rat.t; distance : Rat.t }

let least = Rat.make Z.one (Z.of_int 100)

(* {1 The ball} *)

let parallels n = (n / 2) - 1

(* All points of the circle, since each one is the sum of a series. *)
let circle n = Array.init n (Named_solids.on_circle n)

let ball n =
  let circle = circle n in
  let rings = parallels n in
  let index j k = 1 + ((j - 1) * n) + (k mod n) in
  let north = 1 + (rings * n) in
  let place j k =
    (* From the south pole, at -1/4 of a turn. *)
    let radius, z = circle.((j + n - (n / 4)) mod n) in
    let x, y = circle.(k) in
    Vec.make (Rat.mul radius x) (Rat.mul radius y) z
  in
  let vertex i =
    if i = 0 then ("south", Vec.of_ints 0 0 (-1))
    else if i = north then ("north", Vec.of_ints 0 0 1)
    else
      let j = ((i - 1) / n) + 1 and k = (i - 1) mod n in
      (Printf.sprintf "v%d_%d" j (k + 1), place j k)
  in
  let face i =
    let j = i / n and k = i mod n in
    let name = Printf.sprintf "f%d_%d" (j + 1) (k + 1) in
    if j = 0 then (name, [| 0; index 1 (k + 1); index 1 k |])
    else if j = rings then (name, [| index j k; index j (k + 1); north |])
    else (name, [| index j k; index j (k + 1); index (j + 1) (k + 1); index (j + 1) k |])
  in
  { Polyhedron.ifs_vertices = Array.init (north + 1) vertex; ifs_faces = Array.init ((rings + 1) * n) face }

(* {1 How near} *)

(* The least square of the distances of the face planes of [ball n] from the centre. Points of the circle at
   quarters of a turn from each other, and opposite ones, are exact images: the faces of one quarter of the
   southern half tell all. *)
let inner_square n =
  let p = ball n in
  let place v = snd p.ifs_vertices.(v) in
  let square (_, corners) =
    let a = place corners.(0) in
    let normal = Vec.cross (Vec.sub (place corners.(1)) a) (Vec.sub (place corners.(2)) a) in
    let offset = Vec.dot normal a in
    Rat.div (Rat.mul offset offset) (Vec.norm2 normal)
  in
  let quarter j = List.init (n / 4) (fun k -> p.ifs_faces.((j * n) + k)) in
  List.concat_map quarter (List.init (n / 4) Fun.id)
  |> List.fold_left (fun least f -> Rat.min least (square f)) Rat.one

(* The same of the sides of the polygon, in the plane. *)
let polygon_square n =
  let circle = circle n in
  let square k =
    let x, y = circle.(k) and x', y' = circle.((k + 1) mod n) in
    let cross = Rat.sub (Rat.mul x y') (Rat.mul y x') in
    let dx = Rat.sub x' x and dy = Rat.sub y' y in
    Rat.div (Rat.mul cross cross) (Rat.add (Rat.mul dx dx) (Rat.mul dy dy))
  in
  List.fold_left (fun least k -> Rat.min least (square k)) Rat.one (List.init n Fun.id)

(* The greatest multiple of 2^-20 whose square is at most this, 0 < q <= 1: a number below the root. *)
let root_below q =
  let scale = Z.shift_left Z.one 20 in
  Rat.make (Z.sqrt (Rat.floor (Rat.mul q (Rat.make (Z.mul scale scale) Z.one)))) scale

let near side inner =
  match side with
  | Inscribed -> (Rat.one, Rat.sub Rat.one inner)
  | Circumscribed ->
    let factor = Rat.div Rat.one inner in
    (factor, Rat.sub factor Rat.one)

let rec from square side d n =
  let factor, distance = near side (root_below (square n)) in
  if Rat.compare distance d <= 0 then { corners = n; factor; distance } else from square side d (n + 4)

let disc side d = from polygon_square side d 4
let sphere side d = from inner_square side d 4
