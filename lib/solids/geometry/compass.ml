(* The directions are projected on the octahedron |x| + |y| + |z| = 1 and from there on the plane of x and y,
   where eight cells a side, over and under it, each have their vertex. With a byte each they fill three lines
   of cache; where there are more than 256 vertices, the first of them have to do. *)
type t = Bytes.t

let half = 4
let row = (2 * half) + 1

(* The coordinates go from 0 to [2 half]; what is no number becomes some integer, of which four bits are taken. *)
let[@inline] index x y z =
  let s = float_of_int half /. (Float.abs x +. Float.abs y +. Float.abs z) in
  let i = int_of_float ((x *. s) +. float_of_int half) and j = int_of_float ((y *. s) +. float_of_int half) in
  (2 * ((row * (i land 15)) + (j land 15))) + Bool.to_int (z < 0.)

let size = 2 * ((row * 15) + 16)

let make ~count ~highest =
  let cells = Bytes.make size '\000' in
  let middle k = (float_of_int (Int.min k ((2 * half) - 1) - half) +. 0.5) /. float_of_int half in
  for i = 0 to row - 1 do
    for j = 0 to row - 1 do
      let x = middle i and y = middle j in
      let z = Float.max 0. (1. -. Float.abs x -. Float.abs y) in
      let set below z =
        Bytes.set_uint8 cells ((2 * ((row * i) + j)) + below) (Int.min (Int.min 255 (count - 1)) (highest x y z))
      in
      set 0 z;
      set 1 (-.z)
    done
  done;
  cells

let[@inline] look cells x y z = Char.code (Bytes.unsafe_get cells (index x y z))
