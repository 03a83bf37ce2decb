open Scc_exact

type pair = { first : Feature.t; second : Feature.t; dimension : int }

(* {1 The highest pair}

   Let r be the offset, M the obstacle A - B, N the normal cone of M at r, and n a direction in the relative
   interior of N, such as the sum of the extreme directions. Then F(M, n), the face of M that is highest in the
   direction n, is the face that has r in its relative interior. It is F(A, n) - F(B, -n), and the relative
   interior of a sum is the sum of the relative interiors; so some a in relint F(A, n) and b in
   relint F(B, -n) have a - b = r: the two features touch. Since n separates the bodies, all of A n (B + r) lies
   in the plane of n, so it is F(A, n) n (F(B, -n) + r); the relative interiors intersect, so the relative
   interior of this intersection is theirs. Hence the two features are the highest pair (reading I-4).

   If another pair of features touches at a point x, then x lies in F(A, n), and a feature whose relative
   interior meets a face of A lies in that face whole. So all touching pairs are found among the closures of
   the two (reading I-3). *)

(* The feature of a solid that is highest in a direction: uphill from where the compass points, to a vertex without
   a higher neighbour. The neighbours that are as high are on the same edge or face. *)
let support (s : Solid.t) (n : Ivec.t) =
  let t = s.topology in
  let rise v w = Z.sign (Ivec.dot n (Ivec.sub s.vertices.(w) s.vertices.(v))) in
  let rec climb v k level =
    if k = t.first.(v + 1) then (v, level)
    else
      let w = t.neighbour.(k) in
      match rise v w with
      | 0 -> climb v (k + 1) (w :: level)
      | r -> if r > 0 then climb w t.first.(w) [] else climb v (k + 1) level
  in
  let start = Compass.look s.shadow.compass (Z.to_float n.x) (Z.to_float n.y) (Z.to_float n.z) in
  let found = function Some i -> i | None -> Scc_base.Bug.fail __POS__ "a supporting plane holds no feature" in
  match climb start t.first.(start) [] with
  | v, [] -> Feature.Vertex v
  | v, [ w ] -> Feature.Edge (found (Topology.edge_between t v w))
  | v, w :: x :: _ -> Feature.Face (found (Topology.common_face t v w x))

(* The separating direction n of above, and the highest pair. *)
let supports (o : Obstacle.t) r =
  let n = List.fold_left Ivec.add Ivec.zero (Obstacle.separating o r) in
  (n, support o.a n, support o.b (Ivec.neg n))

(* {1 The common plane}

   Both closures lie in one plane orthogonal to n. Leaving out a coordinate along which n does not vanish maps
   that plane to two dimensions one to one, affinely, and keeps all that is asked for here. *)

(* Keeps the sense of rotation about n. *)
let flat (n : Ivec.t) (p : Ivec.t) =
  let x, y, s =
    if Z.sign n.z <> 0 then (p.x, p.y, Z.sign n.z)
    else if Z.sign n.y <> 0 then (p.z, p.x, Z.sign n.y)
    else (p.y, p.z, Z.sign n.x)
  in
  if s > 0 then { Flat.x; y } else { x = y; y = x }

(* The vertices of A and of B + r, flat, over one denominator. *)
let flatten (o : Obstacle.t) r n =
  let p, q = Ivec.of_vec r in
  let den = Z.lcm q (Z.lcm o.a.denominator o.b.denominator) in
  let over d = Ivec.scale (Z.divexact den d) in
  let offset = over q p in
  ( Array.map (fun v -> flat n (over o.a.denominator v)) o.a.vertices,
    Array.map (fun v -> flat n (Ivec.add offset (over o.b.denominator v))) o.b.vertices )

let shape points = function
  | [ v ] -> Flat.Point points.(v)
  | [ v; w ] -> Segment (points.(v), points.(w))
  | vs -> Polygon (List.map (Array.get points) vs)

(* A face of B has its outside towards -n. *)
let reversed = function Flat.Polygon ps -> Flat.Polygon (List.rev ps) | s -> s

let compare_pair p q =
  Feature.compare p.first q.first <?> fun () -> Feature.compare p.second q.second

let pairs of_a of_b =
  let pair (first, s) (second, t) =
    if Flat.meet s t then Some { first; second; dimension = Flat.dimension s t } else None
  in
  List.sort compare_pair (List.concat_map (fun x -> List.filter_map (pair x) of_b) of_a)

let touching (o : Obstacle.t) r =
  let n, fa, fb = supports o r in
  let points_a, points_b = flatten o r n in
  let shapes (s : Solid.t) points f =
    List.map (fun f -> (f, shape points (Solid.corners s f))) (Polyhedron.closure s.polyhedron [ f ])
  in
  pairs (shapes o.a points_a fa) (List.map (fun (f, s) -> (f, reversed s)) (shapes o.b points_b fb))

let highest (o : Obstacle.t) r =
  let n, fa, fb = supports o r in
  let points_a, points_b = flatten o r n in
  let dimension =
    Flat.dimension (shape points_a (Solid.corners o.a fa)) (shape points_b (Solid.corners o.b fb))
  in
  { first = fa; second = fb; dimension }

let region (o : Obstacle.t) r =
  let n, fa, fb = supports o r in
  let points_a, points_b = flatten o r n in
  let ca = Solid.corners o.a fa and cb = Solid.corners o.b fb in
  let ends_a = List.map (Solid.vertex o.a) ca in
  let ends_b = List.map (fun i -> Vec.add r (Solid.vertex o.b i)) cb in
  let b = shape points_b cb in
  let ends_b = match b with Polygon _ -> List.rev ends_b | Point _ | Segment _ -> ends_b in
  Flat.region ~normal:(Ivec.to_vec n) (shape points_a ca, ends_a) (reversed b, ends_b)
