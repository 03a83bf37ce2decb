open Scc_exact

(* Bounds at time 0: x0 y0 z0 x1 y1 z1; then of the velocity: least x, y, z, greatest x, y, z. Least bounds are
   never +infinity and greatest bounds never -infinity, which [down] and [up] after each operation keep so. So
   no operation below meets infinity - infinity. *)
type t = float array

let down = Float.pred
let up = Float.succ

(* Each operation on floats rounds to the nearest, so that the exact result lies between its neighbours. *)
let make box ~(at : Vec.t) ~(velocity : Vec.t) =
  let low axis q = down (Float_box.down q +. Float_box.low box axis)
  and high axis q = up (Float_box.up q +. Float_box.high box axis) in
  [|
    low 0 at.x; low 1 at.y; low 2 at.z;
    high 0 at.x; high 1 at.y; high 2 at.z;
    Float_box.down velocity.x; Float_box.down velocity.y; Float_box.down velocity.z;
    Float_box.up velocity.x; Float_box.up velocity.y; Float_box.up velocity.z;
  |]

(* An edge at x + u t with x >= x0 and u >= u0 has x + u t >= x0 + u0 t for t >= 0, which is least at one end of
   the interval of time. In a product that is 0 * infinity, u0 would be 0: no product is taken then. *)
let swept (b : t) ~from ~until =
  let low = [| b.(0); b.(1); b.(2) |] and high = [| b.(3); b.(4); b.(5) |] in
  for k = 0 to 2 do
    let u0 = b.(6 + k) and u1 = b.(9 + k) in
    if u0 > 0. then low.(k) <- down (b.(k) +. down (u0 *. from))
    else if u0 < 0. then low.(k) <- down (b.(k) +. down (u0 *. until));
    if u1 < 0. then high.(k) <- up (b.(3 + k) +. up (u1 *. from))
    else if u1 > 0. then high.(k) <- up (b.(3 + k) +. up (u1 *. until))
  done;
  Float_box.make ~low ~high

(* The boxes overlap along an axis at time t iff neither begins after the other has ended:
   x0 + u0 t <= x1' + u1' t, that is w t <= g with w = u0 - u1' and g = x1' - x0, and the same with the boxes
   exchanged. With w rounded down and g up the condition is weaker; for w > 0 it says t <= g/w, for w < 0 it says
   t >= g/w, and for w = 0 that g >= 0. The six conditions are kept together as an interval of time, each
   quotient rounded so that the interval grows. A quotient that is a NaN (infinite g and w) narrows nothing. *)
let may_meet (a : t) (b : t) ~from ~until =
  let least = ref from and greatest = ref until in
  let axis = ref 0 in
  while !axis < 3 do
    let k = !axis in
    let w = down (a.(6 + k) -. b.(9 + k)) and g = up (b.(3 + k) -. a.(k)) in
    if w > 0. then begin
      let t = up (g /. w) in
      if t < !greatest then greatest := t
    end
    else if w < 0. then begin
      let t = down (g /. w) in
      if t > !least then least := t
    end
    else if g < 0. then greatest := neg_infinity;
    let w = down (b.(6 + k) -. a.(9 + k)) and g = up (a.(3 + k) -. b.(k)) in
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
