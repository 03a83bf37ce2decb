open Scc_geometry

let[@inline] get (a : float array) i = Array.unsafe_get a i

(* {1 Rates} *)

let across (r : Flight.turn) (n : float array) (rate : float array) =
  rate.(0) <- (r.wy *. n.(2)) -. (r.wz *. n.(1));
  rate.(1) <- (r.wz *. n.(0)) -. (r.wx *. n.(2));
  rate.(2) <- (r.wx *. n.(1)) -. (r.wy *. n.(0))

let distinct (v : int array) count =
  match count with
  | 1 -> 1
  | 2 -> if v.(0) = v.(1) then 1 else 2
  | _ ->
    if v.(0) = v.(1) then if v.(1) = v.(2) then 1 else 2
    else if v.(2) = v.(0) || v.(2) = v.(1) then 2
    else 3

(* From vertex i to j, in the world. *)
let edge (f : Flight.body) i j : Shadow.floats =
  let s = f.solid.shadow and r = f.now in
  let x = s.xs.(j) -. s.xs.(i) and y = s.ys.(j) -. s.ys.(i) and z = s.zs.(j) -. s.zs.(i) in
  {
    x = (r.xx *. x) +. (r.xy *. y) +. (r.xz *. z);
    y = (r.yx *. x) +. (r.yy *. y) +. (r.yz *. z);
    z = (r.zx *. x) +. (r.zy *. y) +. (r.zz *. z);
  }

let other (v : int array) = if v.(1) <> v.(0) then v.(1) else v.(2)

let cross (a : Shadow.floats) (b : Shadow.floats) : Shadow.floats =
  { x = (a.y *. b.z) -. (a.z *. b.y); y = (a.z *. b.x) -. (a.x *. b.z); z = (a.x *. b.y) -. (a.y *. b.x) }

let turning (r : Flight.turn) v = cross { x = r.wx; y = r.wy; z = r.wz } v

(* g = e x f has the direction of n or the opposite one, and so has its rate that of the rate of n. *)
let edges (p : Separation.t) (s : Gjk.t) =
  let f = p.flight in
  let a = edge f.a s.va.(0) (other s.va) and b = edge f.b s.vb.(0) (other s.vb) in
  let g = cross a b in
  let u = cross (turning f.a.now a) b and v = cross a (turning f.b.now b) in
  let along = (g.x *. p.n.(0)) +. (g.y *. p.n.(1)) +. (g.z *. p.n.(2)) in
  let x = (u.x +. v.x) /. along and y = (u.y +. v.y) /. along and z = (u.z +. v.z) /. along in
  if Float.abs x +. Float.abs y +. Float.abs z < 0x1p10 *. (f.scales.whirl +. 0x1p-100) then begin
    p.rate.(0) <- x;
    p.rate.(1) <- y;
    p.rate.(2) <- z
  end
  else across f.a.now p.n p.rate

let aim (p : Separation.t) (s : Gjk.t) =
  Array.blit s.n 0 p.n 0 3;
  let f = p.flight in
  match (distinct s.va s.count, distinct s.vb s.count) with
  | 1, 1 -> Array.fill p.rate 0 3 0.
  | 2, 2 -> edges p s
  | na, nb -> across (if na >= nb then f.a.now else f.b.now) p.n p.rate

(* {1 Delays} *)

(* The least t > 0 at which a + b t + c t^2 = 0, for a > 0; infinite if there is none. *)
let first_root a b c =
  let disc = (b *. b) -. (4. *. a *. c) in
  if disc < 0. then infinity
  else
    let d = sqrt disc in
    (* the roots are 2a / (-b + d) and 2a / (-b - d) *)
    let p = -.b +. d and q = -.b -. d in
    if q > 0. then Float.min (2. *. a /. p) (2. *. a /. q) else if p > 0. then 2. *. a /. p else infinity

type delays = { sooner : float; later : float }

(* The height of the first corner over the plane through the origin: all corners are at the same one. *)
let delays (p : Separation.t) (s : Gjk.t) =
  let f = p.flight in
  let from_centre (b : Flight.body) i : Shadow.floats =
    let s = b.solid.shadow and r = b.now in
    let x = s.xs.(i) and y = s.ys.(i) and z = s.zs.(i) in
    {
      x = r.ex +. ((r.xx *. x) +. (r.xy *. y) +. (r.xz *. z));
      y = r.ey +. ((r.yx *. x) +. (r.yy *. y) +. (r.yz *. z));
      z = r.ez +. ((r.zx *. x) +. (r.zy *. y) +. (r.zz *. z));
    }
  in
  let a = turning f.a.now (from_centre f.a s.va.(0)) and b = turning f.b.now (from_centre f.b s.vb.(0)) in
  let x = f.velocity.x +. b.x -. a.x and y = f.velocity.y +. b.y -. a.y and z = f.velocity.z +. b.z -. a.z in
  let n = p.n and rate = p.rate and q = s.p in
  let c0 = (get n 0 *. get q 0) +. (get n 1 *. get q 1) +. (get n 2 *. get q 2) in
  let c1 =
    (get rate 0 *. get q 0) +. (get rate 1 *. get q 1) +. (get rate 2 *. get q 2)
    +. ((get n 0 *. x) +. (get n 1 *. y) +. (get n 2 *. z))
  in
  let c2 = (get rate 0 *. x) +. (get rate 1 *. y) +. (get rate 2 *. z) in
  let bend = 0.5 *. Separation.acceleration p 0. in
  { sooner = first_root c0 c1 (c2 -. bend); later = first_root c0 c1 (c2 +. bend) }

let fitted (p : Separation.t) s =
  let a = p.low.(0) and b = p.low.(1) and c = p.low.(2) in
  let root = first_root a (2. *. (b -. a)) (c -. (2. *. b) +. a) in
  s *. Float.min 0.75 (0.97 *. root)
