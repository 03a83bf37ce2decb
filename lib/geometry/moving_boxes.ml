open Scc_exact

(* Sixteen numbers for each box, side by side in memory since that is what queries of large networks wait for:
   bounds at time 0, x0 y0 z0 x1 y1 z1; bounds of the velocity, least x, y, z and greatest x, y, z; the time; and
   three to spare. Least bounds are never +infinity and greatest bounds never -infinity, which [down] and [up]
   after each operation keep so: no operation below meets infinity - infinity. *)
type t = float array

let size = 16
let velocity = 6
let time = 12
let create n = Array.make (size * n) 0.

(* Each operation on floats rounds to the nearest, so that the exact result lies between its neighbours. *)
let down = Float.pred
let up = Float.succ

let set (b : t) i box ~(at : Vec.t) ~velocity:(v : Vec.t) =
  let i = size * i in
  let axis k q u =
    b.(i + k) <- down (Float_box.down q +. Float_box.low box k);
    b.(i + k + 3) <- up (Float_box.up q +. Float_box.high box k);
    b.(i + velocity + k) <- Float_box.down u;
    b.(i + velocity + k + 3) <- Float_box.up u
  in
  axis 0 at.x v.x;
  axis 1 at.y v.y;
  axis 2 at.z v.z

let until (b : t) i = b.((size * i) + time)
let set_until (b : t) i t = b.((size * i) + time) <- t

(* An edge at x + u t with x >= x0 and u >= u0 has x + u t >= x0 + u0 t for t >= 0, which is least at one end of
   the interval of time. In a product that is 0 * infinity, u0 would be 0: no product is taken then. *)
let swept (b : t) i ~from =
  let until = until b i and i = size * i in
  let low = [| b.(i); b.(i + 1); b.(i + 2) |] and high = [| b.(i + 3); b.(i + 4); b.(i + 5) |] in
  for k = 0 to 2 do
    let u0 = b.(i + velocity + k) and u1 = b.(i + velocity + k + 3) in
    if u0 > 0. then low.(k) <- down (low.(k) +. down (u0 *. from))
    else if u0 < 0. then low.(k) <- down (low.(k) +. down (u0 *. until));
    if u1 < 0. then high.(k) <- up (high.(k) +. up (u1 *. from))
    else if u1 > 0. then high.(k) <- up (high.(k) +. up (u1 *. until))
  done;
  Float_box.make ~low ~high

(* The boxes overlap along an axis at time t iff neither begins after the other has ended:
   x0 + u0 t <= x1' + u1' t, that is w t <= g with w = u0 - u1' and g = x1' - x0, and the same with the boxes
   exchanged. With w rounded down and g up the condition is weaker; for w > 0 it says t <= g/w, for w < 0 it says
   t >= g/w, and for w = 0 that g >= 0. The six conditions are kept together as an interval of time, each
   quotient rounded so that the interval grows. A quotient that is a NaN (infinite g and w) narrows nothing. *)
let may_meet (b : t) i j ~from =
  let i = size * i and j = size * j in
  let least = ref from and greatest = ref b.(i + time) in
  if b.(j + time) < !greatest then greatest := b.(j + time);
  let axis = ref 0 in
  while !axis < 3 do
    let k = !axis in
    let w = down (b.(i + velocity + k) -. b.(j + velocity + k + 3)) and g = up (b.(j + k + 3) -. b.(i + k)) in
    if w > 0. then begin
      let t = up (g /. w) in
      if t < !greatest then greatest := t
    end
    else if w < 0. then begin
      let t = down (g /. w) in
      if t > !least then least := t
    end
    else if g < 0. then greatest := neg_infinity;
    let w = down (b.(j + velocity + k) -. b.(i + velocity + k + 3)) and g = up (b.(i + k + 3) -. b.(j + k)) in
    if w > 0. then begin
      let t = up (g /. w) in
      if t < !greatest then greatest := t
    end
    else if w < 0. then begin
      let t = down (g /. w) in
      if t > !least then least := t
    end
    else if g < 0. then greatest := neg_infinity;
    axis := if !least <= !greatest then k + 1 else 4
  done;
  !axis = 3
