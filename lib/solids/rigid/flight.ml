open Scc_exact
open Scc_geometry

type turn = {
  mutable xx : float;
  mutable xy : float;
  mutable xz : float;
  mutable yx : float;
  mutable yy : float;
  mutable yz : float;
  mutable zx : float;
  mutable zy : float;
  mutable zz : float;
  mutable ex : float;
  mutable ey : float;
  mutable ez : float;
  mutable wx : float;
  mutable wy : float;
  mutable wz : float;
}

type sizes = { since : float; spin : float; reach : float; extent : float }

type body = {
  solid : Solid.t;
  turning : bool;
  spin : Shadow.floats;
  start : turn;
  now : turn;
  sizes : sizes;
}

type scales = { length : float; whirl : float; end_ : float }

type t = {
  a : body;
  b : body;
  offset : Shadow.floats;
  velocity : Shadow.floats;
  here : float array;
  scales : scales;
}

(* Errors, in units of u = 2^-53. Coordinates that come from rationals are within 3u of them, relatively, and
   components of [turned] within 2u.

   [rotation_to], from a quaternion (w, v): N is within 4u, k within 5u, each entry within 17u, as no product of
   k with the sum of the sizes of what it multiplies is greater than 2. So the matrix is within 51u, in the
   Frobenius norm, of that of the quaternion as given in floats. Components of [turned] that are wrong by 2u
   turn by another 4u, hence 57u. The vector of the Cayley map is within 9u, relatively: since + t within 4u,
   spin within 3u, and two products; that turns by 18u at most, hence 69u.

   The product of both is within 57u + 69u + 9u = 135u; the arm, turned, within 69u + 3u + 5u = 77u of its
   length; the offset within 3u + 3u + 2u = 8u of |c| + t |v|; a vertex p, turned, within 135u + 3u + 5u = 143u
   of its length. A sum of such terms has an error of at most 5u more, a product with a vector m one of 6u |m|.
   All that is less than 160u of S = |c| + T |v| + extent_A + extent_B.

   In [separation.ml] the vector m itself is wrong by at most 40u of a bound on it, which adds up to 200u. With
   256u for all of this, the error bounds need no care about their own rounding. *)
let epsilon = 0x1p-45
let widen x = x *. (1. +. 0x1p-40)

let rotation_to r w x y z =
  let xx = x *. x and yy = y *. y and zz = z *. z in
  let k = 2. /. ((w *. w) +. (xx +. yy +. zz)) in
  r.xx <- 1. -. (k *. (yy +. zz));
  r.xy <- k *. ((x *. y) -. (w *. z));
  r.xz <- k *. ((x *. z) +. (w *. y));
  r.yx <- k *. ((x *. y) +. (w *. z));
  r.yy <- 1. -. (k *. (xx +. zz));
  r.yz <- k *. ((y *. z) -. (w *. x));
  r.zx <- k *. ((x *. z) -. (w *. y));
  r.zy <- k *. ((y *. z) +. (w *. x));
  r.zz <- 1. -. (k *. (xx +. yy))

let no_turn () =
  {
    xx = 1.; xy = 0.; xz = 0.; yx = 0.; yy = 1.; yz = 0.; zx = 0.; zy = 0.; zz = 1.;
    ex = 0.; ey = 0.; ez = 0.; wx = 0.; wy = 0.; wz = 0.;
  }

(* A quaternion of more bits than this is cut to so many, which is no error to speak of. *)
let enough_bits = 100

let turned_to r (q : Quaternion.t) =
  if not (Quaternion.is_identity q) then begin
    let spare = Int.max 0 (Quaternion.bits q - enough_bits) in
    let float n = Z.to_float (if spare = 0 then n else Z.shift_right n spare) in
    rotation_to r (float q.w) (float q.x) (float q.y) (float q.z)
  end

let length (v : Shadow.floats) = sqrt ((v.x *. v.x) +. (v.y *. v.y) +. (v.z *. v.z))
let sane (v : Shadow.floats) = Shadow.sane v.x && Shadow.sane v.y && Shadow.sane v.z

(* The centre of the shadow, turned, as seen from the centre of turning. *)
let middle (s : Shadow.t) r : Shadow.floats =
  {
    x = r.ex +. ((r.xx *. s.cx) +. (r.xy *. s.cy) +. (r.xz *. s.cz));
    y = r.ey +. ((r.yx *. s.cx) +. (r.yy *. s.cy) +. (r.yz *. s.cz));
    z = r.ez +. ((r.zx *. s.cx) +. (r.zy *. s.cy) +. (r.zz *. s.cz));
  }

let body (m : Motion.t) =
  let shadow = m.solid.shadow in
  let spin = Shadow.floats m.spin and arm = Shadow.floats m.arm in
  let since = Rat.near_float m.since in
  if not (shadow.usable && sane spin && sane arm && Shadow.sane since) then None
  else begin
    let start = no_turn () in
    turned_to start m.turned;
    start.ex <- arm.x;
    start.ey <- arm.y;
    start.ez <- arm.z;
    let extent =
      length arm
      +. sqrt ((shadow.cx *. shadow.cx) +. (shadow.cy *. shadow.cy) +. (shadow.cz *. shadow.cz))
      +. shadow.outer
    in
    (* [widen] of the extent makes up for the errors of the middle *)
    let reach = length (middle shadow start) +. shadow.outer +. (extent *. epsilon) in
    let sizes = { since; spin = widen (length spin); reach = widen reach; extent = widen extent } in
    let now = { start with ex = start.ex } in
    Some { solid = m.solid; turning = Motion.turns m; spin; start; now; sizes }
  end

let make (a : Motion.t) (b : Motion.t) span =
  match (body a, body b) with
  | Some fa, Some fb ->
    let offset = Shadow.floats (Vec.sub b.centre a.centre) in
    let velocity = Shadow.floats (Vec.sub b.velocity a.velocity) in
    if not (sane offset && sane velocity && Shadow.sane span) then None
    else
      let path = length offset +. (span *. length velocity) in
      let scales =
        {
          length = widen (path +. fa.sizes.extent +. fb.sizes.extent);
          whirl = Float.max fa.sizes.spin fb.sizes.spin;
          end_ = span;
        }
      in
      Some { a = fa; b = fb; offset; velocity; here = [| offset.x; offset.y; offset.z |]; scales }
  | _ -> None

let turn_to (f : body) t =
  if f.turning then begin
    let r = f.now and s = f.start in
    let half = 0.5 *. (f.sizes.since +. t) in
    let x = half *. f.spin.x and y = half *. f.spin.y and z = half *. f.spin.z in
    let xx = x *. x and yy = y *. y and zz = z *. z in
    let k = 2. /. (1. +. (xx +. yy +. zz)) in
    let cxx = 1. -. (k *. (yy +. zz)) and cxy = k *. ((x *. y) -. z) and cxz = k *. ((x *. z) +. y) in
    let cyx = k *. ((x *. y) +. z) and cyy = 1. -. (k *. (xx +. zz)) and cyz = k *. ((y *. z) -. x) in
    let czx = k *. ((x *. z) -. y) and czy = k *. ((y *. z) +. x) and czz = 1. -. (k *. (xx +. yy)) in
    r.xx <- (cxx *. s.xx) +. (cxy *. s.yx) +. (cxz *. s.zx);
    r.xy <- (cxx *. s.xy) +. (cxy *. s.yy) +. (cxz *. s.zy);
    r.xz <- (cxx *. s.xz) +. (cxy *. s.yz) +. (cxz *. s.zz);
    r.yx <- (cyx *. s.xx) +. (cyy *. s.yx) +. (cyz *. s.zx);
    r.yy <- (cyx *. s.xy) +. (cyy *. s.yy) +. (cyz *. s.zy);
    r.yz <- (cyx *. s.xz) +. (cyy *. s.yz) +. (cyz *. s.zz);
    r.zx <- (czx *. s.xx) +. (czy *. s.yx) +. (czz *. s.zx);
    r.zy <- (czx *. s.xy) +. (czy *. s.yy) +. (czz *. s.zy);
    r.zz <- (czx *. s.xz) +. (czy *. s.yz) +. (czz *. s.zz);
    r.ex <- (cxx *. s.ex) +. (cxy *. s.ey) +. (cxz *. s.ez);
    r.ey <- (cyx *. s.ex) +. (cyy *. s.ey) +. (cyz *. s.ez);
    r.ez <- (czx *. s.ex) +. (czy *. s.ey) +. (czz *. s.ez);
    let slow = 0.5 *. k in
    r.wx <- slow *. f.spin.x;
    r.wy <- slow *. f.spin.y;
    r.wz <- slow *. f.spin.z
  end

let move f t =
  turn_to f.a t;
  turn_to f.b t;
  f.here.(0) <- f.offset.x +. (t *. f.velocity.x);
  f.here.(1) <- f.offset.y +. (t *. f.velocity.y);
  f.here.(2) <- f.offset.z +. (t *. f.velocity.z)

(* Along the direction from A's centre to B's when they are nearest, or nearly so, the one is ahead of the other by
   more than both reaches at the start and at the end; then it is so in between. *)
let apart_forever f =
  let c = f.offset and v = f.velocity and last = f.scales.end_ in
  let vv = (v.x *. v.x) +. (v.y *. v.y) +. (v.z *. v.z) in
  let cv = (c.x *. v.x) +. (c.y *. v.y) +. (c.z *. v.z) in
  let t = if cv >= 0. then 0. else Float.min last (-.cv /. vv) in
  let x = c.x +. (t *. v.x) and y = c.y +. (t *. v.y) and z = c.z +. (t *. v.z) in
  let n = sqrt ((x *. x) +. (y *. y) +. (z *. z)) in
  let first = (x *. c.x) +. (y *. c.y) +. (z *. c.z) and rate = (x *. v.x) +. (y *. v.y) +. (z *. v.z) in
  let least = Float.min first (first +. (last *. rate)) in
  least > n *. (f.a.sizes.reach +. f.b.sizes.reach +. (epsilon *. f.scales.length))
