open Scc_exact
open Scc_geometry

type pair = {
  a : Motion.t;
  b : Motion.t;
  from : Rat.t;
  length : Rat.t;
  turn_a : Z.t array array;
  turn_b : Z.t array array;
  points_a : Ivec.t array;
  points_b : Ivec.t array;
  apart : Ivec.t * Ivec.t;
  denominator : Z.t;
  turning : Z.t array array array;
  toward_a : Z.t array array;
  toward_b : Z.t array array;
  scale : Z.t array;
  crossing : Z.t array array array Lazy.t;
}

(* Polynomials over the integers: coefficients from the constant up, at least one, zeros at the end allowed. *)

let add p q =
  let p, q = if Array.length p >= Array.length q then (p, q) else (q, p) in
  Array.mapi (fun i c -> if i < Array.length q then Z.add c q.(i) else c) p

let neg p = Array.map Z.neg p
let sub p q = add p (neg q)
let scale k p = if Z.equal k Z.one then p else Array.map (Z.mul k) p

let mul p q =
  let r = Array.make (Array.length p + Array.length q - 1) Z.zero in
  Array.iteri (fun i a -> Array.iteri (fun j b -> r.(i + j) <- Z.add r.(i + j) (Z.mul a b)) q) p;
  r

let linear c d = if Z.sign d = 0 then [| c |] else [| c; d |]
let sum3 f = add (f 0) (add (f 1) (f 2))

(* [combine v p]: the combination of three polynomials with the coordinates of a vector. *)
let combine (v : Ivec.t) p = add (scale v.x p.(0)) (add (scale v.y p.(1)) (scale v.z p.(2)))
let column i m = Array.map (fun row -> row.(i)) m

(* The matrix of x -> q x q* for a quaternion q: a rotation times |q|^2. *)
let matrix q =
  let w = q.(0) and x = q.(1) and y = q.(2) and z = q.(3) in
  let two p = scale (Z.of_int 2) p in
  let ww = mul w w and xx = mul x x and yy = mul y y and zz = mul z z in
  let xy = mul x y and xz = mul x z and yz = mul y z in
  let wx = mul w x and wy = mul w y and wz = mul w z in
  let ( + ) = add and ( - ) = sub in
  let rows =
    [| [| ww + xx - (yy + zz); two (xy - wz); two (xz + wy) |];
       [| two (xy + wz); ww + yy - (xx + zz); two (yz - wx) |];
       [| two (xz - wy); two (yz + wx); ww + zz - (xx + yy) |] |]
  in
  (rows, ww + xx + (yy + zz))

(* (1 + spin (since + from + length s)/2) times how the solid was turned before, without a common factor. *)
let quaternion (m : Motion.t) from length =
  let start = Vec.scale (Rat.mul Rat.half (Rat.add m.since from)) m.spin in
  let u, d = Ivec.of_vecs [| start; Vec.scale (Rat.mul Rat.half length) m.spin |] in
  let { Quaternion.w; x; y; z } = m.turned in
  let v = Ivec.make x y z in
  (* (r + u)(w + v) = r w - u.v + r v + w u + u x v *)
  let times r u =
    let part = Ivec.add (Ivec.add (Ivec.scale r v) (Ivec.scale w u)) (Ivec.cross u v) in
    [| Z.sub (Z.mul r w) (Ivec.dot u v); part.x; part.y; part.z |]
  in
  let q0 = times d u.(0) and q1 = times Z.zero u.(1) in
  let common = Array.fold_left Z.gcd (Array.fold_left Z.gcd Z.zero q0) q1 in
  Array.map2 (fun c d -> linear (Z.divexact c common) (Z.divexact d common)) q0 q1

(* About the centre, in the frame of the solid, which at the start of the turn was turned by [turned]. *)
let points (m : Motion.t) =
  let arm = Quaternion.apply (Quaternion.inverse m.turned) m.arm in
  Array.init (Array.length m.solid.vertices) (fun i -> Vec.add arm (Solid.vertex m.solid i))

(* With N_A, N_B the rotations of the frames, times the squared lengths D_A, D_B of the quaternions, and c from the
   centre of A to that of B:

   turning = N_A^T N_B, toward_a = D_B N_A^T c, toward_b = D_A N_B^T c, scale = D_A D_B,
   crossing = -N_A^T [c]x N_B, where [c]x y = c x y.

   A vertex of A in space is R_A a with R_A = N_A/D_A and a in [points_a], and c + R_B b is one of B; each
   condition below is multiplied by D_A D_B > 0 and by the common denominator. *)
let pair (a : Motion.t) (b : Motion.t) ~from ~until =
  let length = Rat.sub until from in
  let centre (m : Motion.t) = Vec.axpy from m.velocity m.centre in
  let c0 = Vec.sub (centre b) (centre a) in
  let c1 = Vec.scale length (Vec.sub b.velocity a.velocity) in
  let pa = points a and pb = points b in
  let all, denominator = Ivec.of_vecs (Array.concat [ [| c0; c1 |]; pa; pb ]) in
  let c0 = all.(0) and c1 = all.(1) in
  let points_a = Array.sub all 2 (Array.length pa) in
  let points_b = Array.sub all (2 + Array.length pa) (Array.length pb) in
  let turn_a = quaternion a from length and turn_b = quaternion b from length in
  let na, da = matrix turn_a and nb, db = matrix turn_b in
  let c = [| linear c0.x c1.x; linear c0.y c1.y; linear c0.z c1.z |] in
  let dot p q = sum3 (fun k -> mul p.(k) q.(k)) in
  let against f = Array.init 3 (fun i -> Array.init 3 (fun j -> dot (column i na) (f (column j nb)))) in
  let from_c p =
    let minor i j = sub (mul c.(i) p.(j)) (mul c.(j) p.(i)) in
    [| neg (minor 1 2); neg (minor 2 0); neg (minor 0 1) |]
  in
  let toward n d = Array.init 3 (fun i -> mul d (dot (column i n) c)) in
  {
    a; b; from; length; turn_a; turn_b; points_a; points_b;
    apart = (c0, c1);
    denominator;
    turning = against Fun.id;
    toward_a = toward na db;
    toward_b = toward nb da;
    scale = mul da db;
    crossing = lazy (against from_c);
  }

type t = Face_a of int | Face_b of int | Edges of { a : int; b : int; positive : bool }

let equal x y =
  match (x, y) with
  | Face_a i, Face_a j | Face_b i, Face_b j -> Int.equal i j
  | Edges x, Edges y -> Int.equal x.a y.a && Int.equal x.b y.b && Bool.equal x.positive y.positive
  | (Face_a _ | Face_b _ | Edges _), _ -> false

let conditions p = function
  | Face_a _ -> Array.length p.points_b
  | Face_b _ -> Array.length p.points_a
  | Edges _ -> 5

let polynomial c = Polynomial.of_coefficients (List.map Q.of_bigint (Array.to_list c))
let row m (u : Ivec.t) = Array.init 3 (fun j -> combine u (column j m))
let corner (s : Solid.t) f = (snd s.polyhedron.faces.(f)).(0)

(* n outer normal of a face of A through a0, b a vertex of B: R_A n.(c + R_B b) - n.a0. *)
let face_a p f =
  let n = p.a.solid.normals.(f) in
  let level = Ivec.dot n p.points_a.(corner p.a.solid f) in
  let base = sub (combine n p.toward_a) (scale level p.scale) and along = row p.turning n in
  fun i -> polynomial (add base (combine p.points_b.(i) along))

(* m outer normal of a face of B through b0, a vertex of A: R_B m.(R_A a - c) - m.b0. *)
let face_b p f =
  let m = p.b.solid.normals.(f) in
  let level = Ivec.dot m p.points_b.(corner p.b.solid f) in
  let base = neg (add (combine m p.toward_b) (scale level p.scale)) in
  let along = Array.map (combine m) p.turning in
  fun i -> polynomial (add base (combine p.points_a.(i) along))

(* e an edge of A through a0 between faces of normals n (left) and n' (right), f an edge of B through b0
   between m and m'; the direction is d = R_A e x R_B f or its opposite. d.(c + R_B b0 - R_A a0) is the sum of

   (R_A e x R_B f).c = -R_A e.(c x R_B f),   (R_A e x R_B f).R_B b0 = R_A e.R_B (f x b0),
   -(R_A e x R_B f).R_A a0 = -R_A (a0 x e).R_B f.

   n x e x f = (n.f) e for n orthogonal to e, and n x n' is a positive multiple of e; hence d lies between n
   and n' iff n.f >= 0 and n'.f <= 0, all turned, unless both are 0: e and f are parallel then. In the same
   way, m x (f x e) = (m.e) f and -d = f x e lies between m and m' iff m.e >= 0 and m'.e <= 0. (Between: on the
   arc, shorter than half a circle.) *)
let edges p i j positive =
  let a = p.a.solid and b = p.b.solid in
  let ea = a.topology.edges.(i) and eb = b.topology.edges.(j) in
  let e = a.directions.(i) and f = b.directions.(j) in
  let signed c = polynomial (if positive then c else neg c) in
  let bilinear m u v = combine v (row m u) in
  let offset () =
    let a0 = p.points_a.(ea.tail) and b0 = p.points_b.(eb.tail) in
    add
      (bilinear (Lazy.force p.crossing) e f)
      (sub (bilinear p.turning e (Ivec.cross f b0)) (bilinear p.turning (Ivec.cross a0 e) f))
  in
  fun k ->
    match k with
    | 0 -> signed (offset ())
    | 1 -> signed (bilinear p.turning a.normals.(ea.left) f)
    | 2 -> signed (neg (bilinear p.turning a.normals.(ea.right) f))
    | 3 -> signed (bilinear p.turning e b.normals.(eb.left))
    | _ -> signed (neg (bilinear p.turning e b.normals.(eb.right)))

let condition p = function
  | Face_a f -> face_a p f
  | Face_b f -> face_b p f
  | Edges { a; b; positive } -> edges p a b positive

let parallel p axis =
  match axis with
  | Face_a _ | Face_b _ -> false
  | Edges _ ->
    let condition = condition p axis in
    Polynomial.is_zero (condition 1) && Polynomial.is_zero (condition 2)
