open Scc_exact

type t = { volume : Rat.t; centroid : Vec.t; inertia : Mat.t }

(* Sums over the tetrahedra (0, a, b, c) of the integer points, with D = det (a, b, c), s = a + b + c:
   the volume is D/6, the first moment D/24 s and the second moment D/120 (s s^T + a a^T + b b^T + c c^T). *)
type sums = {
  det : Z.t;
  first : Ivec.t;
  xx : Z.t;
  yy : Z.t;
  zz : Z.t;
  yz : Z.t;
  zx : Z.t;
  xy : Z.t;
}

let zero =
  let o = Z.zero in
  { det = o; first = Ivec.zero; xx = o; yy = o; zz = o; yz = o; zx = o; xy = o }

let add_tetrahedron sums (a : Ivec.t) (b : Ivec.t) (c : Ivec.t) =
  let d = Ivec.det a b c in
  let s = Ivec.add a (Ivec.add b c) in
  let moment acc pa pb pc ps qa qb qc qs =
    let products = Z.(add (add (mul pa qa) (mul pb qb)) (add (mul pc qc) (mul ps qs))) in
    Z.add acc (Z.mul d products)
  in
  {
    det = Z.add sums.det d;
    first = Ivec.add sums.first (Ivec.scale d s);
    xx = moment sums.xx a.x b.x c.x s.x a.x b.x c.x s.x;
    yy = moment sums.yy a.y b.y c.y s.y a.y b.y c.y s.y;
    zz = moment sums.zz a.z b.z c.z s.z a.z b.z c.z s.z;
    yz = moment sums.yz a.y b.y c.y s.y a.z b.z c.z s.z;
    zx = moment sums.zx a.z b.z c.z s.z a.x b.x c.x s.x;
    xy = moment sums.xy a.x b.x c.x s.x a.y b.y c.y s.y;
  }

let add_face points sums corners =
  let p i = points.(corners.(i)) in
  let sums = ref sums in
  for i = 1 to Array.length corners - 2 do
    sums := add_tetrahedron !sums (p 0) (p i) (p (i + 1))
  done;
  !sums

let of_surface points denominator faces =
  let sums = Array.fold_left (add_face points) zero faces in
  if Z.sign sums.det = 0 then Scc_base.Bug.fail __POS__ "mass properties of a surface without volume";
  let over k power n = Rat.make n (Z.mul (Z.of_int k) (Z.pow denominator power)) in
  let volume = over 6 3 sums.det in
  let first = Vec.make (over 24 4 sums.first.x) (over 24 4 sums.first.y) (over 24 4 sums.first.z) in
  let centroid = Vec.scale (Rat.div Rat.one volume) first in
  (* Second moments about the centroid: those about the origin less volume * c c^T = first c^T. *)
  let moment n p q = Rat.sub (over 120 5 n) (Rat.mul p q) in
  let xx = moment sums.xx first.x centroid.x in
  let yy = moment sums.yy first.y centroid.y in
  let zz = moment sums.zz first.z centroid.z in
  let yz = Rat.neg (moment sums.yz first.y centroid.z) in
  let zx = Rat.neg (moment sums.zx first.z centroid.x) in
  let xy = Rat.neg (moment sums.xy first.x centroid.y) in
  let inertia =
    Mat.make
      (Vec.make (Rat.add yy zz) xy zx)
      (Vec.make xy (Rat.add zz xx) yz)
      (Vec.make zx yz (Rat.add xx yy))
  in
  { volume; centroid; inertia }

let of_polyhedron (p : Polyhedron.t) =
  let points, denominator = Ivec.of_vecs (Array.map snd p.vertices) in
  of_surface points denominator (Array.map snd p.faces)

let inertia ~mass t = Mat.scale (Rat.div mass t.volume) t.inertia
