open Scc_exact

type t = {
  question : Question.t;
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

let make (question : Question.t) r w =
  { question; line = lazy (line r w); speed_bound = Shadow.greatest question.velocity }

let times k (v : Ivec.t) = if Z.equal k Z.one then v else Ivec.scale k v

(* {1 The bounds}

   Let u = 2^-53, and m the bound of the portal: the sum of the bounds of the coordinates of A, B and r. The
   coordinates of vertices, r and w are within 3 u of the exact ones, relatively, and those of the centres exact
   (Shadow); two subtractions make a point p = a - b - r. Hence a coordinate of a point, or of the
   centre, is off by at most
     3 u m (conversions) + 2 u m (subtractions), that is 5 u m (1 + small).
   Nothing overflows or comes near to the floats below the normal ones: the coordinates are 0 or between 2^-120
   and 2^120 (Question.make), so that differences of them are 0 or above 2^-173, and every product here has at
   most three factors of that kind. The floats of integers are within 2 u of them, relatively. They may be great: a
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

(* A direction n with its floats and the sum of their sizes. *)
type axis = { n : Ivec.t; f : Shadow.floats; norm1 : float }

let axis (n : Ivec.t) =
  let x = Z.to_float n.x and y = Z.to_float n.y and z = Z.to_float n.z in
  { n; f = { x; y; z }; norm1 = Float.abs x +. Float.abs y +. Float.abs z }

let opposite d = { d with n = Ivec.neg d.n; f = { x = -.d.f.x; y = -.d.f.y; z = -.d.f.z } }

let[@inline] float_dot (f : Shadow.floats) (v : Shadow.floats) = (v.x *. f.x) +. (v.y *. f.y) +. (v.z *. f.z)

(* {1 Points in floats} *)

(* The first coordinates are looked up with a check; there are as many of the others. *)
let[@inline] float_point c p : Shadow.floats =
  let { Question.a; b; offset; _ } = c.question and i = Point.of_a p and j = Point.of_b p in
  let a = a.shadow and b = b.shadow in
  let x = a.xs.(i) -. b.xs.(j) in
  let y = Array.unsafe_get a.ys i -. Array.unsafe_get b.ys j in
  let z = Array.unsafe_get a.zs i -. Array.unsafe_get b.zs j in
  { x = x -. offset.x; y = y -. offset.y; z = z -. offset.z }

let float_centre c : Shadow.floats =
  let { Question.a; b; offset; _ } = c.question in
  let a = a.shadow and b = b.shadow in
  { x = a.cx -. b.cx -. offset.x; y = a.cy -. b.cy -. offset.y; z = a.cz -. b.cz -. offset.z }

(* {1 Exact points} *)

(* A positive multiple of a - b - r. *)
let lift c a da b db =
  let l = Lazy.force c.line in
  let dab = Z.mul da db in
  Ivec.sub
    (times l.scale (Ivec.sub (times db a) (times da b)))
    (times dab l.offset)

let exact_point c p =
  let { Question.a; b; _ } = c.question in
  lift c a.vertices.(Point.of_a p) a.denominator b.vertices.(Point.of_b p) b.denominator

let exact_centre c =
  let a = c.question.a.shadow and b = c.question.b.shadow in
  lift c a.centre a.centre_denominator b.centre b.centre_denominator

let velocity c = (Lazy.force c.line).velocity

(* A product by a factor that is most often 1. *)
let by k x = if k == Z.one then x else Z.mul k x

(* n.(a - b - r) times a positive number. *)
let exact_product c n p =
  let { Question.a; b; _ } = c.question in
  let l = Lazy.force c.line in
  let da = a.denominator and db = b.denominator in
  let of_a = Ivec.dot n a.vertices.(Point.of_a p) and of_b = Ivec.dot n b.vertices.(Point.of_b p) in
  let across = Z.sub (by db of_a) (by da of_b) in
  Z.sub (by l.scale across) (by db (by da (Ivec.dot n l.offset)))

(* The sign of n.p. *)
let side c { n; f; norm1 } p =
  certain (float_dot f (float_point c p)) (0x1p-48 *. norm1 *. c.question.bound) <?> fun () ->
    Z.sign (exact_product c n p)

let along c { n; f; norm1 } =
  certain (float_dot f c.question.velocity) (0x1p-48 *. norm1 *. c.speed_bound) <?> fun () ->
    Z.sign (Ivec.dot n (velocity c))

(* The sign of the determinant of three vectors, the first within [bound], as far as floats tell. *)
let[@inline] orientation c (u : Shadow.floats) (v : Shadow.floats) (w : Shadow.floats) bound =
  let det =
    (u.x *. ((v.y *. w.z) -. (v.z *. w.y)))
    +. (u.y *. ((v.z *. w.x) -. (v.x *. w.z)))
    +. (u.z *. ((v.x *. w.y) -. (v.y *. w.x)))
  in
  certain det (0x1p-45 *. bound *. c.question.bound *. c.question.bound)

(* That of a vector [u], which is [exact c], and two points with their floats, which are made but once. *)
let turn c u bound exact p at_p q at_q =
  match orientation c u at_p at_q bound with
  | 0 -> Z.sign (Ivec.det (exact c) (exact_point c p) (exact_point c q))
  | sign -> sign

(* {1 Supporting planes} *)

(* Whether no vertex of the solid is higher than [v] in the direction n, times [sign]. On a convex solid it is
   enough to look at the neighbours. That [known] is as high as [v] is known. *)
let is_highest (s : Solid.t) v { n; f; norm1 } sign ~known =
  let { Shadow.xs; ys; zs; reach; _ } = s.shadow and { Topology.first; neighbour; _ } = s.topology in
  let bound = 0x1p-48 *. reach *. norm1 in
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

(* With a point that it holds. *)
type plane = { axis : axis; holds : Point.t }

let supporting c axis p =
  let { Question.a; b; _ } = c.question in
  if
    is_highest a (Point.of_a p) axis 1. ~known:nobody && is_highest b (Point.of_b p) axis (-1.) ~known:nobody
  then Some { axis; holds = p }
  else None

let normal p = p.axis.n
let height c p = side c p.axis p.holds
let speed c p = along c p.axis

(* {1 Separation} *)

let short = 0x1p26

(* A direction as a short integer vector: its greatest coordinate becomes [size]. *)
let shorten (v : Shadow.floats) size =
  let k = size /. Shadow.greatest v in
  let round y = int_of_float (Float.round (y *. k)) in
  axis
    (if k < infinity && k > 0. then Ivec.of_ints (round v.x) (round v.y) (round v.z)
     else Ivec.zero)

let supported c ({ n; f; _ } as axis) =
  if Ivec.is_zero n then None
  else
    let { Question.a; b; _ } = c.question and direction = [| f.x; f.y; f.z |] in
    supporting c axis
      (Point.make ~of_a:(Solid.highest a direction 1.) ~of_b:(Solid.highest b direction (-1.)))

(* For n.w >= 0 the obstacle stays behind the plane: with n.p <= 0 for all its points, the line never enters
   its interior. *)
let never c p = speed c p >= 0 && height c p <= 0
let apart c p = height c p < 0
let apart_forever c p = speed c p = 0 && height c p < 0

(* A direction across w that was rounded, by at most 1/2 in each coordinate, may run against w by |w|1 / 2, which
   is at most 3/2 times the greatest coordinate of w; three times w over that coordinate, rounded as well, makes
   up for it. *)
let separating c direction =
  let n = shorten direction short in
  let n = if along c n >= 0 then n else axis (Ivec.add n.n (shorten c.question.velocity 3.).n) in
  supported c n

(* {1 The silhouette} *)

(* From right to left, exactly, times a positive number. *)
let extent c { Portal.right; left } =
  let { Question.a; b; _ } = c.question in
  let of_a = Ivec.sub a.vertices.(Point.of_a left) a.vertices.(Point.of_a right) in
  let of_b = Ivec.sub b.vertices.(Point.of_b left) b.vertices.(Point.of_b right) in
  if Point.of_b right = Point.of_b left then of_a
  else if Point.of_a right = Point.of_a left then Ivec.neg of_b
  else Ivec.sub (times b.denominator of_a) (times a.denominator of_b)

type beside = Never of plane | Crosses | Unknown

(* The outward normal of the edge, seen along w. *)
let beside c (edge : Portal.edge) =
  let n = axis (Ivec.cross (extent c edge) (velocity c)) in
  if Ivec.is_zero n.n then Unknown
  else if side c n edge.right > 0 then Crosses
  else match supporting c n edge.right with Some p -> Never p | None -> Unknown

(* {1 Facets} *)

(* How a portal carries a facet: what its corners are of, in either solid. *)
type corners = Vertex | Edge of (int * int) | Triangle

let corners i j k =
  if i = j then if j = k then Vertex else Edge (i, k)
  else if i = k || j = k then Edge (i, j)
  else Triangle

let level (s : Solid.t) n i j k =
  let at j = j = i || Z.equal (Ivec.dot n s.vertices.(j)) (Ivec.dot n s.vertices.(i)) in
  at j && at k

(* Along an edge, or across a face. *)
let direction_between (s : Solid.t) i j =
  match Topology.edge_between s.topology i j with
  | Some e -> if s.topology.edges.(e).tail = i then s.directions.(e) else Ivec.neg s.directions.(e)
  | None -> Ivec.sub s.vertices.(j) s.vertices.(i)

(* (q - p) x (r - p) *)
let float_normal c { Portal.p; q; r } : Shadow.floats =
  let p = float_point c p and q = float_point c q and r = float_point c r in
  let ex = q.x -. p.x and ey = q.y -. p.y and ez = q.z -. p.z in
  let fx = r.x -. p.x and fy = r.y -. p.y and fz = r.z -. p.z in
  { x = (ey *. fz) -. (ez *. fy); y = (ez *. fx) -. (ex *. fz); z = (ex *. fy) -. (ey *. fx) }

(* Two edges span the facet; which way is out, floats guess, and the neighbours prove. *)
let across c portal (i, i') (j, j') =
  let { Question.a; b; _ } = c.question in
  let n = axis (Ivec.cross (direction_between a i i') (direction_between b j j')) in
  let n = if float_dot n.f (float_normal c portal) < 0. then opposite n else n in
  if (not (Ivec.is_zero n.n)) && is_highest a i n 1. ~known:i' && is_highest b j n (-1.) ~known:j' then
    Some { axis = n; holds = Point.make ~of_a:i ~of_b:j }
  else None

(* Three corners of one face of A, with one vertex of B or several of the same height; or the other way round;
   or two vertices of each. *)
let facet c ({ Portal.p; q; r } as portal) =
  let { Question.a; b; _ } = c.question in
  let i = Point.of_a p and j = Point.of_a q and k = Point.of_a r in
  let i' = Point.of_b p and j' = Point.of_b q and k' = Point.of_b r in
  match (corners i j k, corners i' j' k') with
  | Triangle, _ -> (
      match Topology.common_face a.topology i j k with
      | Some face ->
        let n = axis a.normals.(face) in
        if is_highest b i' n (-1.) ~known:nobody && level b n.n i' j' k' then Some { axis = n; holds = p }
        else None
      | None -> None)
  | _, Triangle -> (
      match Topology.common_face b.topology i' j' k' with
      | Some face ->
        let n = axis (Ivec.neg b.normals.(face)) in
        if is_highest a i n 1. ~known:nobody && level a n.n i j k then Some { axis = n; holds = p } else None
      | None -> None)
  | Edge e, Edge e' -> across c portal e e'
  | Vertex, _ | _, Vertex -> None

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

let tight c p =
  let { Question.a; b; _ } = c.question and i = Point.of_a p and j = Point.of_b p in
  let at_a = around a i and at_b = around b j in
  let of_a e =
    let n = axis a.normals.(face_leaving a i e) in
    if side c n p = 0 && is_highest b j n (-1.) ~known:nobody then Some n.n else None
  in
  let from_a = List.filter_map of_a at_a in
  let of_b f =
    let n = axis (Ivec.neg b.normals.(face_leaving b j f)) in
    if
      side c n p = 0 && is_highest a i n 1. ~known:nobody && not (List.exists (Ivec.equal n.n) from_a)
    then Some n.n
    else None
  in
  let of_both e f = Option.bind (spanned a b e f) (fun n -> if side c (axis n) p = 0 then Some n else None) in
  from_a
  @ List.filter_map of_b at_b
  @ List.concat_map (fun e -> List.filter_map (of_both e) at_b) at_a

(* n.(a - b - r) = (n.w) t *)
let time c f =
  let { Question.a; b; _ } = c.question in
  let n = f.axis.n in
  Rat.make (exact_product c n f.holds) (by b.denominator (by a.denominator (Ivec.dot n (velocity c))))

type crossing = Within | Border of Point.t | Outside

(* The line of a vector [u] through the origin, which runs with the normal of the portal ([sign] is 1) or against
   it (-1): det (u, p, q) times [sign] is, up to a factor, the weight of the third corner, and of three weights one
   is positive. *)
let crossing_of c { Portal.p; q; r } u ~sign bound exact =
  let at_p = float_point c p and at_q = float_point c q and at_r = float_point c r in
  let of_p = sign * turn c u bound exact q at_q r at_r in
  let of_q = sign * turn c u bound exact r at_r p at_p in
  let of_r = sign * turn c u bound exact p at_p q at_q in
  if of_p < 0 || of_q < 0 || of_r < 0 then Outside
  else if of_p > 0 && of_q > 0 && of_r > 0 then Within
  else if of_p > 0 then Border p
  else if of_q > 0 then Border q
  else if of_r > 0 then Border r
  else Outside

let crossing c portal =
  crossing_of c portal c.question.velocity ~sign:(-1) c.speed_bound velocity

let foot c f portal = crossing_of c portal f.axis.f ~sign:1 (Shadow.greatest f.axis.f) (fun _ -> f.axis.n)

let interior c { Portal.right; left } =
  let at_right = float_point c right and at_left = float_point c left in
  let centre = float_centre c and w = c.question.velocity in
  let along p at_p =
    match orientation c w centre at_p c.speed_bound with
    | 0 -> Z.sign (Ivec.det (velocity c) (exact_centre c) (exact_point c p))
    | sign -> sign
  in
  turn c w c.speed_bound velocity right at_right left at_left > 0
  && along right at_right >= 0
  && along left at_left <= 0

let inside c { Portal.p; q; r } =
  let bound = c.question.bound and centre = float_centre c in
  let at_p = float_point c p and at_q = float_point c q and at_r = float_point c r in
  turn c at_p bound (fun c -> exact_point c p) q at_q r at_r > 0
  && turn c centre bound exact_centre p at_p q at_q <= 0
  && turn c centre bound exact_centre q at_q r at_r <= 0
  && turn c centre bound exact_centre r at_r p at_p <= 0
