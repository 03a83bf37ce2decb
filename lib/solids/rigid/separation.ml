type t = { flight : Flight.t; n : float array; rate : float array; low : float array; work : float array }

(* [work]: 0 to 8, three vectors m; 9 to 11, how far a solid reaches along each. *)
let far = 9

let make flight =
  { flight; n = Array.make 3 0.; rate = Array.make 3 0.; low = Array.make 3 0.; work = Array.make 12 0. }

let[@inline] get (a : float array) i = Array.unsafe_get a i
let[@inline] set (a : float array) i x = Array.unsafe_set a i x

(* Let a point of a solid be at e + y at the instant, e the centre of turning, v its velocity, w the angular
   velocity. After a delay r <= s it is at e + y + r (v + w x y) + z, and its product with n + r n' is, without
   z and the part of the centre, y.(n + r (n' + n x w) + r^2 n' x w). Over 0 to s the coefficients of that in
   Bernstein form are the products of y with

   m0 = n,  m1 = n + s/2 (n' + n x w),  m2 = n + s (n' + n x w) + s^2 n' x w.

   The acceleration of the point is orthogonal to the axis and, as w = spin / (1 + |u|^2), of the size |spin|^2
   h (1 + |u|^2)^(-3/2), h its distance from the axis. So z is orthogonal to the axis too, |z| is at most r^2/2
   |spin|^2 reach, and |(n + r n').z| at most r^2/2 |spin| reach |(n + r n') x spin|; the last factor is
   greatest at one of the ends. As r^2/2 = s^2/2 times the last polynomial of the form, that lowers the last
   coefficient alone. The least of a sum over all pairs of vertices is at least the sum of the least of each
   coefficient of B, the greatest of A taken off.

   No |m| exceeds N = (|n| + s |n'|) (1 + s |spin|); the error of a coefficient is at most 200u N S (see
   flight.ml), and that of what z does less than 20u N (1 + s |spin|) S. *)
let vectors p (f : Flight.body) s sign =
  let w = p.work and r = f.now in
  let nx = sign *. get p.n 0 and ny = sign *. get p.n 1 and nz = sign *. get p.n 2 in
  let dx = sign *. get p.rate 0 and dy = sign *. get p.rate 1 and dz = sign *. get p.rate 2 in
  set w 0 nx;
  set w 1 ny;
  set w 2 nz;
  let gx = s *. (dx +. ((ny *. r.wz) -. (nz *. r.wy)))
  and gy = s *. (dy +. ((nz *. r.wx) -. (nx *. r.wz)))
  and gz = s *. (dz +. ((nx *. r.wy) -. (ny *. r.wx))) in
  set w 3 (nx +. (0.5 *. gx));
  set w 4 (ny +. (0.5 *. gy));
  set w 5 (nz +. (0.5 *. gz));
  let ss = s *. s in
  set w 6 (nx +. gx +. (ss *. ((dy *. r.wz) -. (dz *. r.wy))));
  set w 7 (ny +. gy +. (ss *. ((dz *. r.wx) -. (dx *. r.wz))));
  set w 8 (nz +. gz +. (ss *. ((dx *. r.wy) -. (dy *. r.wx))))

(* The greatest products of a point of the solid, as seen from its centre of turning, with the three vectors. *)
let extremes p (f : Flight.body) =
  let w = p.work and r = f.now in
  let shadow = f.solid.shadow in
  let xs = shadow.xs and ys = shadow.ys and zs = shadow.zs in
  let ax = (r.xx *. get w 0) +. (r.yx *. get w 1) +. (r.zx *. get w 2)
  and ay = (r.xy *. get w 0) +. (r.yy *. get w 1) +. (r.zy *. get w 2)
  and az = (r.xz *. get w 0) +. (r.yz *. get w 1) +. (r.zz *. get w 2) in
  let bx = (r.xx *. get w 3) +. (r.yx *. get w 4) +. (r.zx *. get w 5)
  and by = (r.xy *. get w 3) +. (r.yy *. get w 4) +. (r.zy *. get w 5)
  and bz = (r.xz *. get w 3) +. (r.yz *. get w 4) +. (r.zz *. get w 5) in
  let cx = (r.xx *. get w 6) +. (r.yx *. get w 7) +. (r.zx *. get w 8)
  and cy = (r.xy *. get w 6) +. (r.yy *. get w 7) +. (r.zy *. get w 8)
  and cz = (r.xz *. get w 6) +. (r.yz *. get w 7) +. (r.zz *. get w 8) in
  let a = ref neg_infinity and b = ref neg_infinity and c = ref neg_infinity in
  for i = 0 to shadow.count - 1 do
    let x = get xs i and y = get ys i and z = get zs i in
    let h = (x *. ax) +. (y *. ay) +. (z *. az) in
    if h > !a then a := h;
    let h = (x *. bx) +. (y *. by) +. (z *. bz) in
    if h > !b then b := h;
    let h = (x *. cx) +. (y *. cy) +. (z *. cz) in
    if h > !c then c := h
  done;
  set w far (!a +. ((r.ex *. get w 0) +. (r.ey *. get w 1) +. (r.ez *. get w 2)));
  set w (far + 1) (!b +. ((r.ex *. get w 3) +. (r.ey *. get w 4) +. (r.ez *. get w 5)));
  set w (far + 2) (!c +. ((r.ex *. get w 6) +. (r.ey *. get w 7) +. (r.ez *. get w 8)))

let acceleration p s =
  let nx = get p.n 0 and ny = get p.n 1 and nz = get p.n 2 in
  let mx = nx +. (s *. get p.rate 0) and my = ny +. (s *. get p.rate 1) and mz = nz +. (s *. get p.rate 2) in
  let bend (f : Flight.body) =
    if not f.turning then 0.
    else
      let w = f.spin in
      let x = (ny *. w.z) -. (nz *. w.y) and y = (nz *. w.x) -. (nx *. w.z) and z = (nx *. w.y) -. (ny *. w.x) in
      let first = (x *. x) +. (y *. y) +. (z *. z) in
      let x = (my *. w.z) -. (mz *. w.y) and y = (mz *. w.x) -. (mx *. w.z) and z = (mx *. w.y) -. (my *. w.x) in
      let last = (x *. x) +. (y *. y) +. (z *. z) in
      sqrt (Float.max first last) *. f.sizes.spin *. f.sizes.reach *. (1. +. 0x1p-40)
  in
  bend p.flight.a +. bend p.flight.b

let holds p s =
  let f = p.flight and w = p.work in
  let v = f.velocity in
  let x = get f.here 0 and y = get f.here 1 and z = get f.here 2 in
  let nx = get p.n 0 and ny = get p.n 1 and nz = get p.n 2 in
  let mx = nx +. (s *. get p.rate 0) and my = ny +. (s *. get p.rate 1) and mz = nz +. (s *. get p.rate 2) in
  (* of the centres *)
  let c0 = (nx *. x) +. (ny *. y) +. (nz *. z) in
  let c1 = (mx *. x) +. (my *. y) +. (mz *. z) +. (s *. ((nx *. v.x) +. (ny *. v.y) +. (nz *. v.z))) in
  let c2 = (mx *. (x +. (s *. v.x))) +. (my *. (y +. (s *. v.y))) +. (mz *. (z +. (s *. v.z))) in
  vectors p f.a s 1.;
  extremes p f.a;
  let a0 = get w far and a1 = get w (far + 1) and a2 = get w (far + 2) in
  vectors p f.b s (-1.);
  extremes p f.b;
  let size = sqrt ((nx *. nx) +. (ny *. ny) +. (nz *. nz)) in
  let last = sqrt ((mx *. mx) +. (my *. my) +. (mz *. mz)) in
  let whirl = 1. +. (s *. f.scales.whirl) in
  let error = Flight.epsilon *. f.scales.length *. (size +. size +. last) *. whirl *. whirl in
  let bend = 0.5 *. s *. s *. acceleration p s in
  set p.low 0 (c0 -. a0 -. get w far -. error);
  set p.low 1 ((0.5 *. (c0 +. c1)) -. a1 -. get w (far + 1) -. error);
  set p.low 2 (c2 -. a2 -. get w (far + 2) -. error -. bend);
  get p.low 0 > 0. && get p.low 1 > 0. && get p.low 2 > 0.
