open Scc_exact

type t = {
  s : Portal.t;
  line : line Lazy.t;
  speed_bound : float;  (** no coordinate of w is greater *)
}

(* r and w over one positive denominator. *)
and line = { offset : Ivec.t; velocity : Ivec.t; scale : Z.t }

let line r w =
  if Ivec.is_integral r && Ivec.is_integral w then
    { offset = Ivec.numerators r; velocity = Ivec.numerators w; scale = Z.one }
  else
    let rw, scale = Ivec.of_vecs [| r; w |] in
    { offset = rw.(0); velocity = rw.(1); scale }

let greatest (x : float array) at =
  Float.max (Float.abs x.(at)) (Float.max (Float.abs x.(at + 1)) (Float.abs x.(at + 2)))

(* For a body at rest the place of the velocity is the search's own, and no bound holds. *)
let make (s : Portal.t) r w =
  let speed = greatest s.x Portal.velocity in
  { s; line = lazy (line r w); speed_bound = (if speed > 0. then speed else infinity) }

let times k (v : Ivec.t) = if Z.equal k Z.one then v else Ivec.scale k v

(* {1 The bounds}

   Let u = 2^-53, and m the bound of the portal: the sum of the bounds of the coordinates of A, B and r. The
   coordinates of vertices, r and w are within 3 u of the exact ones, relatively, and those of the centres exact
   (Shadow); two subtractions make a point p = a - b - r. Hence a coordinate of a point, or of the
   centre, is off by at most
     3 u m (conversions) + 2 u m (subtractions), that is 5 u m (1 + small).
   Nothing overflows or comes near to the floats below the normal ones: the coordinates are 0 or between 2^-120
   and 2^120 (Portal.make), so that differences of them are 0 or above 2^-173, and every product here has at most
   three factors of that kind. The floats of integers are within 2 u of them, relatively. They may be great: a
   bound, 2^-48 of its products or so, is only trusted below 2^900, where no product overflows; so a direction that
   has no floats leaves the case open.

   A product n.p of an integer vector n: each term is off by |ni| m (2u + 5u + u), and two sums add
   2 u |n|1 m; in all 10 u |n|1 m (1 + small). The bound used is 32 u.
   The product n.(p - q) for vertices p and q of one solid, whose coordinates are at most h: conversions and
   subtraction make 6 u h + 2 u h, and with |p - q| <= 2 h each term is off by |ni| (8 u h + 2h (2u + u)), the sums
   by 2 u 2 h |n|1; in all 18 u |n|1 h, where 32 u is used.
   The product n.w is off by (3u + 2u + u + 2u) |n|1 |w|, where 32 u is used.

   The determinant of three vectors with coordinates at most m1, m2, m3, each off by at most e1, e2, e3 times
   that, with e <= 5 u: a minor of the last two is off by 2 m2 m3 (e2 + e3 + u) + 2 u m2 m3 = 24 u m2 m3, its
   product with a coordinate by m1 m2 m3 (24 u + 2 (5 u + u)) = 36 u, the sum of three of those by 108 u and for
   two additions 12 u more: 120 u m1 m2 m3 (1 + small). The bound used is 256 u. *)

let largest = 0x1p900

let[@inline] certain x bound =
  if bound < largest then if x > bound then 1 else if x < -.bound then -1 else 0 else 0

(* A direction n with its floats. *)
type floats = { x : float; y : float; z : float; norm1 : float }
type axis = { n : Ivec.t; f : floats }

let axis (n : Ivec.t) =
  let x = Z.to_float n.x and y = Z.to_float n.y and z = Z.to_float n.z in
  { n; f = { x; y; z; norm1 = Float.abs x +. Float.abs y +. Float.abs z } }

let opposite d = { n = Ivec.neg d.n; f = { d.f with x = -.d.f.x; y = -.d.f.y; z = -.d.f.z } }

let[@inline] float_dot f (x : float array) at = (x.(at) *. f.x) +. (x.(at + 1) *. f.y) +. (x.(at + 2) *. f.z)

(* {1 Exact points} *)

(* A positive multiple of a - b - r. *)
let lift c a da b db =
  let l = Lazy.force c.line in
  let dab = Z.mul da db in
  Ivec.sub
    (times l.scale (Ivec.sub (times db a) (times da b)))
    (times dab l.offset)

let exact_point c k =
  let s = c.s in
  lift c s.a.vertices.(s.va.(k)) s.a.denominator s.b.vertices.(s.vb.(k)) s.b.denominator

let exact_centre c =
  let a = c.s.a.shadow and b = c.s.b.shadow in
  lift c a.centre a.centre_denominator b.centre b.centre_denominator

let velocity c = (Lazy.force c.line).velocity

(* A product by a factor that is most often 1. *)
let by k x = if k == Z.one then x else Z.mul k x

(* n.(a - b - r) times a positive number. *)
let exact_product c n va vb =
  let { Portal.a; b; _ } = c.s in
  let l = Lazy.force c.line in
  let da = a.denominator and db = b.denominator in
  let across = Z.sub (by db (Ivec.dot n a.vertices.(va))) (by da (Ivec.dot n b.vertices.(vb))) in
  Z.sub (by l.scale across) (by db (by da (Ivec.dot n l.offset)))

(* The sign of n.p for point [k]. *)
let side c { n; f } k =
  let s = c.s in
  let sign = certain (float_dot f s.x (Portal.point k)) (0x1p-48 *. f.norm1 *. s.bound) in
  if sign <> 0 then sign else Z.sign (exact_product c n s.va.(k) s.vb.(k))

let along c { n; f } =
  let sign = certain (float_dot f c.s.x Portal.velocity) (0x1p-48 *. f.norm1 *. c.speed_bound) in
  if sign <> 0 then sign else Z.sign (Ivec.dot n (velocity c))

(* The sign of the determinant of the vectors at three places: in floats, or of the integers that [exact]
   gives. *)
let orientation c i j k bound exact =
  let x = c.s.x in
  let det =
    (x.(i) *. ((x.(j + 1) *. x.(k + 2)) -. (x.(j + 2) *. x.(k + 1))))
    +. (x.(i + 1) *. ((x.(j + 2) *. x.(k)) -. (x.(j) *. x.(k + 2))))
    +. (x.(i + 2) *. ((x.(j) *. x.(k + 1)) -. (x.(j + 1) *. x.(k))))
  in
  let sign = certain det (0x1p-45 *. bound *. c.s.bound *. c.s.bound) in
  if sign <> 0 then sign
  else
    let u, v, w = exact () in
    Z.sign (Ivec.det u v w)

(* det (w, pi, pj) *)
let turn c i j =
  orientation c Portal.velocity (Portal.point i) (Portal.point j) c.speed_bound (fun () ->
      (velocity c, exact_point c i, exact_point c j))

(* {1 Supporting planes} *)

(* Whether no vertex of the solid is higher than [v] in the direction n, times [sign]. On a convex solid it is
   enough to look at the neighbours. That [known] is as high as [v] is known. *)
let is_highest (s : Solid.t) v { n; f } sign ~known =
  let { Shadow.xs; ys; zs; reach; _ } = s.shadow and { Topology.first; neighbour; _ } = s.topology in
  let bound = 0x1p-48 *. reach *. f.norm1 in
  let nx = sign *. f.x and ny = sign *. f.y and nz = sign *. f.z in
  let vx = xs.(v) and vy = ys.(v) and vz = zs.(v) in
  let k = ref first.(v) and last = first.(v + 1) in
  while
    !k < last
    &&
    let j = neighbour.(!k) in
    match certain (((xs.(j) -. vx) *. nx) +. ((ys.(j) -. vy) *. ny) +. ((zs.(j) -. vz) *. nz)) bound with
    | -1 -> true
    | 1 -> false
    | _ ->
      j = known
      ||
      let rise = Z.sign (Ivec.dot n (Ivec.sub s.vertices.(j) s.vertices.(v))) in
      if sign > 0. then rise <= 0 else rise >= 0
  do
    incr k
  done;
  !k = last

let nobody = -1

type plane = { axis : axis; va : int; vb : int }

let supporting c axis va vb =
  if is_highest c.s.a va axis 1. ~known:nobody && is_highest c.s.b vb axis (-1.) ~known:nobody then
    Some { axis; va; vb }
  else None

let normal p = p.axis.n

(* Point 3 is free between searches. *)
let height c p =
  Portal.place c.s 3 p.va p.vb;
  side c p.axis 3

let speed c p = along c p.axis

(* {1 Separation} *)

let short = 0x1p26

(* The direction at a place as a short integer vector: its greatest coordinate becomes [size]. *)
let shorten (x : float array) at size =
  let k = size /. greatest x at in
  let round y = int_of_float (Float.round (y *. k)) in
  axis
    (if k < infinity && k > 0. then Ivec.of_ints (round x.(at)) (round x.(at + 1)) (round x.(at + 2))
     else Ivec.zero)

let aim c { f; _ } =
  let x = c.s.x in
  x.(Portal.direction) <- f.x;
  x.(Portal.direction + 1) <- f.y;
  x.(Portal.direction + 2) <- f.z

let supported c n =
  aim c n;
  Portal.support c.s 3;
  if Ivec.is_zero n.n then None else supporting c n c.s.va.(3) c.s.vb.(3)

(* For n.w >= 0 the obstacle stays behind the plane: with n.p <= 0 for all its points, the line never enters
   its interior. *)
let never c p = speed c p >= 0 && height c p <= 0
let apart c p = height c p < 0
let apart_forever c p = speed c p = 0 && height c p < 0

(* A direction across w that was rounded, by at most 1/2 in each coordinate, may run against w by |w|1 / 2, which
   is at most 3/2 times the greatest coordinate of w; three times w over that coordinate, rounded as well, makes
   up for it. *)
let separating c =
  let n = shorten c.s.x Portal.direction short in
  let n = if along c n >= 0 then n else axis (Ivec.add n.n (shorten c.s.x Portal.velocity 3.).n) in
  supported c n

(* {1 The silhouette} *)

(* p5 - p4, exactly, times a positive number. *)
let edge c =
  let { Portal.a; b; va; vb; _ } = c.s in
  let of_a = Ivec.sub a.vertices.(va.(5)) a.vertices.(va.(4)) in
  let of_b = Ivec.sub b.vertices.(vb.(5)) b.vertices.(vb.(4)) in
  if vb.(4) = vb.(5) then of_a
  else if va.(4) = va.(5) then Ivec.neg of_b
  else Ivec.sub (times b.denominator of_a) (times a.denominator of_b)

type beside = Never of plane | Crosses | Unknown

(* The outward normal of the edge, seen along w. *)
let beside c =
  let n = axis (Ivec.cross (edge c) (velocity c)) in
  if Ivec.is_zero n.n then Unknown
  else if side c n 4 > 0 then Crosses
  else match supporting c n c.s.va.(4) c.s.vb.(4) with Some p -> Never p | None -> Unknown

(* {1 Facets} *)

let distinct (v : int array) =
  if v.(0) = v.(1) then if v.(1) = v.(2) then 1 else 2
  else if v.(0) = v.(2) || v.(1) = v.(2) then 2
  else 3

(* The two different entries of three. *)
let two (v : int array) = if v.(0) = v.(1) then (v.(0), v.(2)) else (v.(0), v.(1))

let level (s : Solid.t) n (v : int array) =
  let at i = i = v.(0) || Z.equal (Ivec.dot n s.vertices.(i)) (Ivec.dot n s.vertices.(v.(0))) in
  at v.(1) && at v.(2)

(* Along an edge, or across a face. *)
let direction_between (s : Solid.t) (i, j) =
  match Topology.edge_between s.topology i j with
  | Some e -> if s.topology.edges.(e).tail = i then s.directions.(e) else Ivec.neg s.directions.(e)
  | None -> Ivec.sub s.vertices.(j) s.vertices.(i)

(* Two edges span the facet; which way is out, floats guess, and the neighbours prove. *)
let across c a b =
  let n = axis (Ivec.cross (direction_between c.s.a a) (direction_between c.s.b b)) in
  let n = if float_dot n.f c.s.x Portal.direction < 0. then opposite n else n in
  if
    (not (Ivec.is_zero n.n))
    && is_highest c.s.a (fst a) n 1. ~known:(snd a)
    && is_highest c.s.b (fst b) n (-1.) ~known:(snd b)
  then Some { axis = n; va = fst a; vb = fst b }
  else None

(* Three corners of one face of A, with one vertex of B or several of the same height; or the other way round;
   or two vertices of each. *)
let facet c =
  let { Portal.a; b; va; vb; _ } = c.s in
  if va.(0) < 0 || va.(1) < 0 || va.(2) < 0 then None
  else
    match (distinct va, distinct vb) with
    | 3, _ -> (
        match Topology.common_face a.topology va.(0) va.(1) va.(2) with
        | Some face ->
          let n = axis a.normals.(face) in
          if is_highest b vb.(0) n (-1.) ~known:nobody && level b n.n vb then
            Some { axis = n; va = va.(0); vb = vb.(0) }
          else None
        | None -> None)
    | _, 3 -> (
        match Topology.common_face b.topology vb.(0) vb.(1) vb.(2) with
        | Some face ->
          let n = axis (Ivec.neg b.normals.(face)) in
          if is_highest a va.(0) n 1. ~known:nobody && level a n.n va then
            Some { axis = n; va = va.(0); vb = vb.(0) }
          else None
        | None -> None)
    | 2, 2 -> across c (two va) (two vb)
    | _ -> None

(* {1 All facets that hold the origin}

   Let the origin lie on the border of the portal, a combination of its corners in which corner k has a positive
   weight. In the direction n of a facet that holds the origin no point of the obstacle is beyond it, so that
   corner k = a - b is as high as the origin: a is among the highest of A and b among the lowest of B. Hence
   (Minkowski.facets) n is the normal of a face at a, or opposite to one at b, or a product of two edges
   at a and b, whose arcs on the Gauss map cross properly. *)

let around (s : Solid.t) v =
  let { Topology.first; along; _ } = s.topology in
  List.init (first.(v + 1) - first.(v)) (fun k -> along.(first.(v) + k))

let face_leaving (s : Solid.t) v e =
  let e = s.topology.edges.(e) in
  if e.tail = v then e.left else e.right

(* The normal of the facet that the edges [e] of A and [f] of B span, if they do. *)
let spanned (a : Solid.t) (b : Solid.t) e f =
  let d = a.directions.(e) and d' = b.directions.(f) in
  let e = a.topology.edges.(e) and f = b.topology.edges.(f) in
  let sign n d = Z.sign (Ivec.dot n d) in
  let s = sign a.normals.(e.left) d' in
  if
    s <> 0
    && sign a.normals.(e.right) d' = -s
    && sign b.normals.(f.left) d = s
    && sign b.normals.(f.right) d = -s
  then
    let n = Ivec.primitive (Ivec.cross d d') in
    Some (if s > 0 then n else Ivec.neg n)
  else None

let tight c k =
  let { Portal.a; b; va; vb; _ } = c.s in
  let i = va.(k) and j = vb.(k) in
  let at_a = around a i and at_b = around b j in
  let of_a e =
    let n = axis a.normals.(face_leaving a i e) in
    if side c n k = 0 && is_highest b j n (-1.) ~known:nobody then Some n.n else None
  in
  let from_a = List.filter_map of_a at_a in
  let of_b f =
    let n = axis (Ivec.neg b.normals.(face_leaving b j f)) in
    if
      side c n k = 0 && is_highest a i n 1. ~known:nobody && not (List.exists (Ivec.equal n.n) from_a)
    then Some n.n
    else None
  in
  let of_both e f = Option.bind (spanned a b e f) (fun n -> if side c (axis n) k = 0 then Some n else None) in
  from_a
  @ List.filter_map of_b at_b
  @ List.concat_map (fun e -> List.filter_map (of_both e) at_b) at_a

(* n.(a - b - r) = (n.w) t *)
let time c f =
  let { Portal.a; b; _ } = c.s in
  let n = f.axis.n in
  Rat.make (exact_product c n f.va f.vb)
    (by b.denominator (by a.denominator (Ivec.dot n (velocity c))))

type crossing = Within | Border of int | Outside

(* From the signs of the weights of the three corners, of which one is positive. *)
let crossing_of q0 q1 q2 =
  if q0 < 0 || q1 < 0 || q2 < 0 then Outside
  else if q0 > 0 && q1 > 0 && q2 > 0 then Within
  else if q0 > 0 then Border 0
  else if q1 > 0 then Border 1
  else if q2 > 0 then Border 2
  else Outside

(* det (w, pi, pj) is, up to a factor, the weight of the third corner. *)
let crossing c = crossing_of (-turn c 1 2) (-turn c 2 0) (-turn c 0 1)

let foot c f =
  aim c f.axis;
  let bound = greatest c.s.x Portal.direction in
  let turn i j =
    orientation c Portal.direction (Portal.point i) (Portal.point j) bound (fun () ->
        (f.axis.n, exact_point c i, exact_point c j))
  in
  crossing_of (turn 1 2) (turn 2 0) (turn 0 1)

let interior c =
  let centre k =
    orientation c Portal.velocity Portal.centre (Portal.point k) c.speed_bound (fun () ->
        (velocity c, exact_centre c, exact_point c k))
  in
  turn c 4 5 > 0 && centre 4 >= 0 && centre 5 <= 0

let inside c =
  let { Portal.va; _ } = c.s in
  let point k () = exact_point c k in
  let cone i j =
    orientation c Portal.centre (Portal.point i) (Portal.point j) c.s.bound (fun () ->
        (exact_centre c, point i (), point j ()))
  in
  va.(0) >= 0
  && orientation c (Portal.point 0) (Portal.point 1) (Portal.point 2) c.s.bound (fun () ->
      (point 0 (), point 1 (), point 2 ()))
     > 0
  && cone 0 1 <= 0 && cone 1 2 <= 0 && cone 2 0 <= 0
