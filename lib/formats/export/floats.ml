open Scc_base
open Scc_exact

exception Too_great

let finite x = if Float.is_finite x then x else raise Too_great

let text x =
  if Float.is_integer x && Float.abs x < 1e15 then Printf.sprintf "%.0f" (x +. 0.)
  else if not (Float.is_finite x) then Bug.fail __POS__ "a number is too great for a float"
  else Float_text.shortest x

let of_rat r = finite (Rat.to_float r +. 0.)
let point (v : Vec.t) = [| of_rat v.x; of_rat v.y; of_rat v.z |]
let single x = finite (Int32.float_of_bits (Int32.bits_of_float x))

let unit integers =
  let greatest = Array.fold_left (fun m z -> Z.max m (Z.abs z)) Z.zero integers in
  let scaled = Array.map (fun z -> of_rat (Rat.make z greatest)) integers in
  let length = sqrt (Array.fold_left (fun sum x -> sum +. (x *. x)) 0. scaled) in
  Array.map (fun x -> x /. length) scaled

(* {1 Angles}

   The functions of the C library differ between machines in the last digit. *)

let pi = 3.14159265358979323846

(* For x >= 0: atan x = 2 atan (x / (1 + sqrt (1 + x^2))), three times, then the series, whose argument is then at
   most tan (pi/16) < 0.2. *)
let atan x =
  let halved x = x /. (1. +. sqrt (1. +. (x *. x))) in
  let x = halved (halved (halved x)) in
  let square = x *. x in
  let rec sum k acc = if k < 0 then acc else sum (k - 1) ((1. /. float_of_int ((2 * k) + 1)) -. (square *. acc)) in
  8. *. x *. sum 14 0.

let atan2 y x =
  let height = Float.abs y and width = Float.abs x in
  let angle =
    if height = 0. && width = 0. then 0.
    else if height <= width then atan (height /. width)
    else (pi /. 2.) -. atan (width /. height)
  in
  let angle = if x < 0. then pi -. angle else angle in
  if y < 0. then -.angle else angle

(* The first component that is not 0 is positive, so that the angle is at most pi. *)
let axis_angle (q : Quaternion.t) =
  if Quaternion.is_identity q then [| 0.; 0.; 1.; 0. |]
  else
    let axis = unit [| q.x; q.y; q.z |] and all = unit [| q.w; q.x; q.y; q.z |] in
    let length = sqrt ((all.(1) *. all.(1)) +. (all.(2) *. all.(2)) +. (all.(3) *. all.(3))) in
    Array.append axis [| 2. *. atan2 length all.(0) |]

let euler q =
  let m = Quaternion.to_mat q in
  let f = of_rat in
  let sine = f m.r0.z in
  let cosine = sqrt (Float.max 0. (1. -. (sine *. sine))) in
  let y = atan2 sine cosine in
  (* where x and z turn about one axis, x does it alone *)
  if cosine < 1e-7 then [| atan2 (f m.r2.y) (f m.r1.y); y; 0. |]
  else [| atan2 (-.f m.r1.z) (f m.r2.z); y; atan2 (-.f m.r0.y) (f m.r0.x) |]
