open Scc_exact
open Scc_geometry

(* Sixteen numbers for each box, side by side in memory since that is what queries of large networks wait for:
   first the time; then for each axis the bounds at time 0, x0 and x1, and those of the velocity, u0 and u1; and
   three to spare. Least bounds are never +infinity and greatest bounds never -infinity, which [down] and [up]
   after each operation keep so: no operation below meets infinity - infinity. *)
type t = float array

let size = 16
let along axis = 1 + (4 * axis)
let create n = Array.make (size * n) 0.
let count (b : t) = Array.length b / size

(* Each operation on floats rounds to the nearest, so that the exact result lies between its neighbours. *)
let[@inline] down x = Next_float.pred x
let[@inline] up x = Next_float.succ x

let set (b : t) i box ~(at : Vec.t) ~(velocity : Vec.t) =
  let axis k q u =
    let a = (size * i) + along k in
    b.(a) <- Next_float.sum_below (Float_box.down q) (Float_box.low box k);
    b.(a + 1) <- Next_float.sum_above (Float_box.up q) (Float_box.high box k);
    b.(a + 2) <- Float_box.down u;
    b.(a + 3) <- Float_box.up u
  in
  axis 0 at.x velocity.x;
  axis 1 at.y velocity.y;
  axis 2 at.z velocity.z

let until (b : t) i = b.(size * i)
let set_until (b : t) i t = b.(size * i) <- t

(* An edge at x + u t with x >= x0 and u >= u0 has x + u t >= x0 + u0 t for t >= 0, which is least at one end of
   the interval of time. In a product that is 0 * infinity, u0 would be 0: no product is taken then. *)
let swept (b : t) i ~from =
  let until = until b i in
  let low = [| 0.; 0.; 0. |] and high = [| 0.; 0.; 0. |] in
  for k = 0 to 2 do
    let a = (size * i) + along k in
    let x0 = b.(a) and x1 = b.(a + 1) and u0 = b.(a + 2) and u1 = b.(a + 3) in
    low.(k) <-
      (if u0 > 0. then down (x0 +. down (u0 *. from))
       else if u0 < 0. then down (x0 +. down (u0 *. until))
       else x0);
    high.(k) <-
      (if u1 < 0. then up (x1 +. up (u1 *. from))
       else if u1 > 0. then up (x1 +. up (u1 *. until))
       else x1)
  done;
  Float_box.make ~low ~high

(* A quotient at least, or at most, the exact one; where that is zero, it is. *)
let[@inline] above g w = if g = 0. then 0. else up (g /. w)
let[@inline] below g w = if g = 0. then 0. else down (g /. w)

(* The boxes overlap along an axis at time t iff neither begins after the other has ended:
   x0 + u0 t <= x1' + u1' t, that is w t <= g with w = u0 - u1' and g = x1' - x0, and the same with the boxes
   exchanged. With w rounded down and g up the condition is weaker; for w > 0 it says t <= g/w, for w < 0 it says
   t >= g/w, and for w = 0 that g >= 0. The six conditions are kept together as an interval of time, each
   quotient rounded so that the interval grows. A quotient that is a NaN (infinite g and w) narrows nothing. What
   remains begins before infinity, as it is rounded down.

   Their interiors overlap where all of this is so without equality: for w = 0 that is g > 0, and an interval of
   one instant has none. *)
let overlap ~interiors (a : t) i (b : t) j ~from ~until =
  let least = ref from and greatest = ref until in
  let axis = ref 0 in
  while !axis < 3 do
    let k = !axis in
    let i = (size * i) + along k and j = (size * j) + along k in
    let w = Next_float.sum_below a.(i + 2) (-.b.(j + 3)) and g = Next_float.sum_above b.(j + 1) (-.a.(i)) in
    if w > 0. then begin
      let t = above g w in
      if t < !greatest then greatest := t
    end
    else if w < 0. then begin
      let t = below g w in
      if t > !least then least := t
    end
    else if g < 0. || (interiors && g = 0.) then greatest := neg_infinity;
    let w = Next_float.sum_below b.(j + 2) (-.a.(i + 3)) and g = Next_float.sum_above a.(i + 1) (-.b.(j)) in
    if w > 0. then begin
      let t = above g w in
      if t < !greatest then greatest := t
    end
    else if w < 0. then begin
      let t = below g w in
      if t > !least then least := t
    end
    else if g < 0. || (interiors && g = 0.) then greatest := neg_infinity;
    axis := if !least < !greatest || ((not interiors) && !least = !greatest) then k + 1 else 4
  done;
  if !axis = 3 then !least else infinity

let may_meet b i j ~from =
  let one = until b i and two = until b j in
  overlap ~interiors:false b i b j ~from ~until:(if two < one then two else one) < infinity

let not_before a i b j = overlap ~interiors:false a i b j ~from:0. ~until:infinity
let not_inside_before a i b j = overlap ~interiors:true a i b j ~from:0. ~until:infinity
