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

let corners (s : Solid.t) = function
  | Feature.Vertex i -> [ i ]
  | Feature.Edge i ->
    let v, w = s.polyhedron.edges.(i) in
    [ v; w ]
  | Feature.Face i -> Array.to_list (snd s.polyhedron.faces.(i))

(* {1 The common plane}

   Both closures lie in one plane orthogonal to n. Leaving out a coordinate along which n does not vanish maps
   that plane to two dimensions one to one, affinely, and keeps all that is asked for here. *)

type point = { x : Z.t; y : Z.t }

(* Keeps the sense of rotation about n. *)
let flat (n : Ivec.t) (p : Ivec.t) =
  let x, y, s =
    if Z.sign n.z <> 0 then (p.x, p.y, Z.sign n.z)
    else if Z.sign n.y <> 0 then (p.z, p.x, Z.sign n.y)
    else (p.y, p.z, Z.sign n.x)
  in
  if s > 0 then { x; y } else { x = y; y = x }

(* The vertices of A and of B + r, flat, over one denominator. *)
let flatten (o : Obstacle.t) r n =
  let p, q = Ivec.of_vec r in
  let den = Z.lcm q (Z.lcm o.a.denominator o.b.denominator) in
  let over d = Ivec.scale (Z.divexact den d) in
  let offset = over q p in
  ( Array.map (fun v -> flat n (over o.a.denominator v)) o.a.vertices,
    Array.map (fun v -> flat n (Ivec.add offset (over o.b.denominator v))) o.b.vertices )

type shape = Point of point | Segment of point * point | Polygon of point list  (** counter-clockwise about n *)

let shape points = function
  | [ v ] -> Point points.(v)
  | [ v; w ] -> Segment (points.(v), points.(w))
  | vs -> Polygon (List.map (Array.get points) vs)

(* A face of B has its outside towards -n. *)
let reversed = function Polygon ps -> Polygon (List.rev ps) | s -> s

(* The affine form kx x + ky y + k. *)
type form = { kx : Z.t; ky : Z.t; k : Z.t }

let value f p = Z.add (Z.mul f.kx p.x) (Z.add (Z.mul f.ky p.y) f.k)
let through kx ky p = { kx; ky; k = Z.neg (Z.add (Z.mul kx p.x) (Z.mul ky p.y)) }

(* Positive on the left of the line from a to b. *)
let left_of a b = through (Z.sub a.y b.y) (Z.sub b.x a.x) a

(* Positive where the segment from a to b has not begun: on the side of b of the normal at a. *)
let beyond a b = through (Z.sub b.x a.x) (Z.sub b.y a.y) a

let sides ps =
  let rec go first = function
    | [ last ] -> [ left_of last first ]
    | a :: (b :: _ as rest) -> left_of a b :: go first rest
    | [] -> []
  in
  go (List.hd ps) ps

(* The forms that vanish on the relative interior of a shape, and those that are positive there: together
   they describe it. *)
let forms = function
  | Point p -> ([ through Z.one Z.zero p; through Z.zero Z.one p ], [])
  | Segment (a, b) -> ([ left_of a b ], [ beyond a b; beyond b a ])
  | Polygon ps -> ([], sides ps)

(* {1 Relative interiors that intersect}

   Along the segment from a to b a form goes from its value at a to its value at b, so that the pair of them
   says all: the form at parameter t is (1 - t) at_a + t at_b. *)

(* Exact parameters, num/den with den > 0. *)
type parameter = { num : Z.t; den : Z.t }

let less s t = Z.lt (Z.mul s.num t.den) (Z.mul t.num s.den)

(* Where the form vanishes, for values of different sign. *)
let root (at_a, at_b) =
  let d = Z.sub at_a at_b in
  if Z.sign d > 0 then { num = at_a; den = d } else { num = Z.neg at_a; den = Z.neg d }

let sign_at t (at_a, at_b) = Z.sign (Z.add (Z.mul at_a (Z.sub t.den t.num)) (Z.mul at_b t.num))

(* The bounds of the parameters in (0, 1) at which all forms of a shape are as they should: an open interval,
   or a single one (two equal bounds). *)
let interval a b (zero, positive) =
  let values f = (value f a, value f b) in
  let zero = List.map values zero and positive = List.map values positive in
  let constant (s, t) = Z.sign s = 0 && Z.sign t = 0 in
  match List.find_opt (fun v -> not (constant v)) zero with
  | Some ((s, t) as v) ->
    if Z.sign s * Z.sign t >= 0 then None
    else
      let t = root v in
      if List.for_all (fun v -> sign_at t v = 0) zero && List.for_all (fun v -> sign_at t v > 0) positive
      then Some (t, t)
      else None
  | None ->
    let narrow bounds ((s, t) as v) =
      match bounds with
      | None -> None
      | Some (low, high) ->
        if Z.sign s > 0 && Z.sign t >= 0 || (Z.sign s >= 0 && Z.sign t > 0) then bounds
        else if Z.sign s <= 0 && Z.sign t <= 0 then None
        else
          let t = root v in
          let low = if Z.sign s < 0 && less low t then t else low in
          let high = if Z.sign s > 0 && less t high then t else high in
          if less low high then Some (low, high) else None
    in
    List.fold_left narrow (Some ({ num = Z.zero; den = Z.one }, { num = Z.one; den = Z.one })) positive

(* Two polygons occur only as the highest pair, whose relative interiors are known to intersect. *)
let intersect s t =
  match (s, t) with
  | Point p, other | other, Point p ->
    let zero, positive = forms other in
    List.for_all (fun f -> Z.sign (value f p) = 0) zero
    && List.for_all (fun f -> Z.sign (value f p) > 0) positive
  | Segment (a, b), other | other, Segment (a, b) -> Option.is_some (interval a b (forms other))
  | Polygon _, Polygon _ -> true

(* Of the intersection, for shapes whose relative interiors intersect. *)
let dimension s t =
  match (s, t) with
  | Point _, _ | _, Point _ -> 0
  | Segment (a, b), Segment (c, d) ->
    let l = left_of a b in
    if Z.equal (value l c) (value l d) then 1 else 0
  | Segment _, Polygon _ | Polygon _, Segment _ -> 1
  | Polygon _, Polygon _ -> 2

let compare_pair p q =
  let c = Feature.compare p.first q.first in
  if c <> 0 then c else Feature.compare p.second q.second

let touching (o : Obstacle.t) r =
  let n, fa, fb = supports o r in
  let points_a, points_b = flatten o r n in
  let shapes (s : Solid.t) points f =
    List.map (fun f -> (f, shape points (corners s f))) (Polyhedron.closure s.polyhedron [ f ])
  in
  let of_a = shapes o.a points_a fa in
  let of_b = List.map (fun (f, s) -> (f, reversed s)) (shapes o.b points_b fb) in
  let pair (first, s) (second, t) =
    if intersect s t then Some { first; second; dimension = dimension s t } else None
  in
  List.sort compare_pair (List.concat_map (fun x -> List.filter_map (pair x) of_b) of_a)

let highest (o : Obstacle.t) r =
  let n, fa, fb = supports o r in
  let points_a, points_b = flatten o r n in
  let dimension = dimension (shape points_a (corners o.a fa)) (shape points_b (corners o.b fb)) in
  { first = fa; second = fb; dimension }

(* {1 The region} *)

let at p q t = Vec.axpy (Rat.make t.num t.den) (Vec.sub q p) p

(* The part of a convex polygon where a form is not negative. The form is not negative on the whole of some
   inner part of the polygon, so that no corner is doubled. *)
let clip polygon form =
  let valued = List.map (fun p -> (p, form p)) polygon in
  let step (p, s) (q, t) =
    let crosses = Rat.sign s * Rat.sign t < 0 in
    let crossing = if crosses then [ Vec.axpy (Rat.div s (Rat.sub s t)) (Vec.sub q p) p ] else [] in
    if Rat.sign s >= 0 then p :: crossing else crossing
  in
  let rec go first = function
    | [ last ] -> step last first
    | p :: (q :: _ as rest) -> step p q @ go first rest
    | [] -> []
  in
  go (List.hd valued) valued

(* The intersection of two polygons of one plane, counter-clockwise about n, whose inner parts intersect. *)
let common n p q =
  let side a b x = Vec.dot n (Vec.cross (Vec.sub b a) (Vec.sub x a)) in
  let rec go first p = function
    | [ last ] -> clip p (side last first)
    | a :: (b :: _ as rest) -> go first (clip p (side a b)) rest
    | [] -> p
  in
  go (List.hd q) p q

let region (o : Obstacle.t) r =
  let n, fa, fb = supports o r in
  let points_a, points_b = flatten o r n in
  let ca = corners o.a fa and cb = corners o.b fb in
  let ends_a = List.map (Solid.vertex o.a) ca in
  let ends_b = List.map (fun i -> Vec.add r (Solid.vertex o.b i)) cb in
  match (shape points_a ca, ends_a, reversed (shape points_b cb), ends_b) with
  | Point _, ends, _, _ | _, _, Point _, ends -> ends
  | Segment (a, b), ends, other, _ | other, _, Segment (a, b), ends -> (
      match (interval a b (forms other), ends) with
      | Some (low, high), [ p; q ] ->
        if less low high then [ at p q low; at p q high ] else [ at p q low ]
      | _ -> Scc_base.Bug.fail __POS__ "the highest pair does not touch")
  | Polygon _, p, Polygon _, q -> common (Ivec.to_vec n) p (List.rev q)
