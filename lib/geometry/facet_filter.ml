open Scc_exact

(* Five floats for each facet: the normal n, the offset h = num, and |n|1 = |nx| + |ny| + |nz|. *)
type t = float array

let stride = 5

let make facets =
  let f = Array.make (stride * Array.length facets) 0. in
  Array.iteri
    (fun k ({ normal; num; _ } : Minkowski.facet) ->
       let x = Z.to_float normal.x and y = Z.to_float normal.y and z = Z.to_float normal.z in
       let at = stride * k in
       f.(at) <- x;
       f.(at + 1) <- y;
       f.(at + 2) <- z;
       f.(at + 3) <- Z.to_float num;
       f.(at + 4) <- Float.abs x +. Float.abs y +. Float.abs z)
    facets;
  f

(* [mp] and [mv] are the greatest absolute values of the coordinates. *)
type line = {
  px : float; py : float; pz : float; mp : float;
  vx : float; vy : float; vz : float; mv : float;
  q : float;
}

let greatest x y z = Float.max (Float.abs x) (Float.max (Float.abs y) (Float.abs z))

let line (p : Ivec.t) (v : Ivec.t) q =
  let px = Z.to_float p.x and py = Z.to_float p.y and pz = Z.to_float p.z in
  let vx = Z.to_float v.x and vy = Z.to_float v.y and vz = Z.to_float v.z in
  let mp = greatest px py pz and mv = greatest vx vy vz in
  { px; py; pz; mp; vx; vy; vz; mv; q = Z.to_float q }

(* The line is inside the plane of a facet while s t <= c, with s = n.v and c = h q - n.p. *)
let guess f l =
  let low = ref neg_infinity and high = ref infinity and entry = ref (-1) and exit = ref (-1) in
  for k = 0 to (Array.length f / stride) - 1 do
    let at = stride * k in
    let x = f.(at) and y = f.(at + 1) and z = f.(at + 2) in
    let s = (x *. l.vx) +. (y *. l.vy) +. (z *. l.vz) in
    let c = (f.(at + 3) *. l.q) -. ((x *. l.px) +. (y *. l.py) +. (z *. l.pz)) in
    let t = c /. s in
    if s < 0. && t > !low then begin
      low := t;
      entry := k
    end
    else if s > 0. && t < !high then begin
      high := t;
      exit := k
    end
  done;
  (!entry, !exit)

(* The error bound. Let u = 2^-53. All inputs are integers; suppose only that their floats are within 2u of
   them, relatively. With t the exact time, its float is within 5u (two conversions and a division).
   A coordinate p + t v is computed within 9u (|p| + t |v|): 2u for p, 5u + 2u + u for the product, u for the
   sum. Its product with a coordinate of n is within 12u, two sums and the last difference make that 15u, and
   h q is within 6u. So the computed  h q - n.(p + t v)  is off by at most
     15u (1 + small) (|h| q + |n|1 (mp + t mv)),
   and 32u times that sum, itself computed within some 10u, is a bound with a factor of two to spare. The
   integers have no floats below 1 but zero, so that underflow is possible in t and t v alone; what it changes
   is below |n|1 (mv + 2) 2^-1073, which 32u |n|1 exceeds for any mv that is a float: hence the summand 1.
   Where something overflows, the bound is above the limit, or not a number, and the case is left open. *)
let side f l t k =
  let at = stride * k in
  let x = l.px +. (t *. l.vx) and y = l.py +. (t *. l.vy) and z = l.pz +. (t *. l.vz) in
  let height = f.(at + 3) *. l.q in
  let slack = height -. ((f.(at) *. x) +. (f.(at + 1) *. y) +. (f.(at + 2) *. z)) in
  let bound = 0x1p-48 *. (Float.abs height +. (f.(at + 4) *. (l.mp +. (t *. l.mv) +. 1.))) in
  if bound < 1e280 then if slack > bound then 1 else if slack < -.bound then -1 else 0 else 0
