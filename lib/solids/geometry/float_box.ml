open Scc_exact

(* x0 y0 z0 x1 y1 z1 *)
type t = float array

(* [Rat.to_float] gives the nearest float, so that the number lies between the float's neighbours: strictly below
   [succ infinity] = infinity and above [pred infinity], the greatest finite float, when it is too great for a
   float, and in the same way below. What is a float stays one: what does not move must not seem to, nor what
   touches to overlap. *)
let down q =
  let x = Rat.to_float q in
  if Rat.is_float q then x else Next_float.pred x

let up q =
  let x = Rat.to_float q in
  if Rat.is_float q then x else Next_float.succ x

let of_corners (a : Vec.t) (b : Vec.t) = [| down a.x; down a.y; down a.z; up b.x; up b.y; up b.z |]

(* No sum here is infinity - infinity: what is rounded down is never +infinity, and what is rounded up never
   -infinity. *)
let at (p : Vec.t) (b : t) =
  let low q x = Next_float.sum_below (down q) x and high q x = Next_float.sum_above (up q) x in
  [| low p.x b.(0); low p.y b.(1); low p.z b.(2); high p.x b.(3); high p.y b.(4); high p.z b.(5) |]

(* An edge at x + u t with x >= x0 and u >= u0 has x + u t >= x0 + u0 t, which is least at the end if u0 < 0. *)
let swept (v : Vec.t) ~until (b : t) =
  if Vec.is_zero v then b
  else
    let low u x =
      let u = down u in
      if u < 0. then Next_float.pred (x +. Next_float.pred (u *. until)) else x
    and high u x =
      let u = up u in
      if u > 0. then Next_float.succ (x +. Next_float.succ (u *. until)) else x
    in
    [| low v.x b.(0); low v.y b.(1); low v.z b.(2); high v.x b.(3); high v.y b.(4); high v.z b.(5) |]

let make ~low ~high = [| low.(0); low.(1); low.(2); high.(0); high.(1); high.(2) |]
let low (b : t) axis = b.(axis)
let high (b : t) axis = b.(axis + 3)

let meet (a : t) (b : t) =
  a.(0) <= b.(3) && b.(0) <= a.(3) && a.(1) <= b.(4) && b.(1) <= a.(4) && a.(2) <= b.(5) && b.(2) <= a.(5)

let hull boxes =
  let least k = Array.fold_left (fun x (b : t) -> Float.min x b.(k)) infinity boxes in
  let greatest k = Array.fold_left (fun x (b : t) -> Float.max x b.(k)) neg_infinity boxes in
  [| least 0; least 1; least 2; greatest 3; greatest 4; greatest 5 |]

let equal (a : t) (b : t) =
  let rec from k = k = 6 || (Float.equal a.(k) b.(k) && from (k + 1)) in
  from 0

let extent (b : t) = Float.max (b.(3) -. b.(0)) (Float.max (b.(4) -. b.(1)) (b.(5) -. b.(2)))
