(* Why local tests and one ray are enough.

   Let E1, E2 and E4 hold, let every edge be strictly convex (the next face's corners strictly behind this
   face), and let o be strictly behind every face. Project the surface from o onto the sphere of
   directions. Each face, seen from behind, maps one to one and keeps its orientation; two faces at an edge
   run along it in opposite directions, so they map to opposite sides of it. So, but for finitely many
   points (the vertices), the projection is a local homeomorphism; the surface is compact, hence over the
   sphere without the finitely many images of vertices (which is connected) it is a covering of some degree
   k, and over each direction there are k points counted with multiplicity. If the ray from o through an
   inner point of face 0 meets no other face, that direction has one point, where the projection is a
   local homeomorphism: k = 1, and the surface is the boundary of a star-shaped body whose edges are all
   convex. At a vertex the directions into the body then form a simple spherical polygon whose corners are
   all convex, so the body is convex near vertices as well, and a connected closed set that is locally
   convex is convex (Tietze, Nakajima). Strictly convex edges make its faces maximal: E5. The other way
   round, the mean of all corners of all faces of a solid convex polyhedron is strictly behind every
   face, and each ray
   from it leaves the body once. This is the test of Mehlhorn et al., Checking geometric programs or
   verification of geometric structures (1999). *)
open Scc_exact

type t = { points : Ivec.t array; faces : int array array; normals : Ivec.t array }

(* The sign of the side of the plane of [f] on which the point [p / scale] lies: positive in front. *)
let side_scaled s f scale p =
  let base = s.points.(s.faces.(f).(0)) in
  Z.sign (Ivec.dot s.normals.(f) (Ivec.sub p (Ivec.scale scale base)))

let side s f v = side_scaled s f Z.one s.points.(v)

(* Six times the signed volume: pyramids over the faces, of a third of the height times the area each,
   and {!Face_check.normal} is twice the area vector. *)
let volume6 s =
  let origin = s.points.(s.faces.(0).(0)) in
  let face sum f corners =
    Z.add sum (Ivec.dot s.normals.(f) (Ivec.sub s.points.(corners.(0)) origin))
  in
  let sum = ref Z.zero in
  Array.iteri (fun f corners -> sum := face !sum f corners) s.faces;
  !sum

let turn_over s =
  let reverse a =
    let n = Array.length a in
    Array.init n (fun i -> a.(n - 1 - i))
  in
  { s with faces = Array.map reverse s.faces; normals = Array.map Ivec.neg s.normals }

(* Each edge once, from its face of smaller number. The neighbour [g] runs along the edge from [w] to [v] and
   lies to the left of it, in the direction normal x (v - w); [after] gives its corner that comes next. *)
let edge_faults s across after =
  let edge f acc v w =
    let g, place = across v w in
    let into = Ivec.cross s.normals.(g) (Ivec.sub s.points.(v) s.points.(w)) in
    if g < f then acc
    else
      match Z.sign (Ivec.dot s.normals.(f) into) with
      | -1 -> acc
      | 1 -> Polyhedron_fault.Not_convex (f, after g place) :: acc
      | _ when Z.sign (Ivec.dot s.normals.(f) s.normals.(g)) > 0 ->
        Polyhedron_fault.Coplanar_neighbours (f, g) :: acc
      | _ -> Polyhedron_fault.In_plane (f, after g place) :: acc
  in
  let found = ref [] in
  let face f corners =
    let n = Array.length corners in
    for i = 0 to n - 1 do
      found := edge f !found corners.(i) corners.((i + 1) mod n)
    done
  in
  Array.iteri face s.faces;
  List.rev !found

let find_corner corners test =
  let n = Array.length corners in
  let rec go i = if i >= n then None else if test corners.(i) then Some corners.(i) else go (i + 1) in
  go 0

(* The sum of all corners of all faces and their number: their mean is inside a convex polyhedron. *)
let mean s =
  let add (sum, k) v = (Ivec.add sum s.points.(v), k + 1) in
  let sum, k = Array.fold_left (Array.fold_left add) (Ivec.zero, 0) s.faces in
  (sum, Z.of_int k)

(* A vertex in front of [f]: there is one when the mean is not strictly behind [f] and some vertex is off its
   plane. *)
let in_front s f =
  let n = Array.length s.faces in
  let rec go g =
    if g >= n then None
    else
      match find_corner s.faces.(g) (fun v -> side s f v > 0) with
      | Some v -> Some v
      | None -> go (g + 1)
  in
  go 0

(* The faces other than 0 that the ray from the mean through the middle of face 0 meets, borders included.
   All is scaled by [k], the number of corners, and by that of the corners of face 0. *)
let second_hit s (sum, k) =
  let corners = s.faces.(0) in
  let m = Z.of_int (Array.length corners) in
  let middle = Array.fold_left (fun acc v -> Ivec.add acc s.points.(v)) Ivec.zero corners in
  let ray = Ivec.sub (Ivec.scale k middle) (Ivec.scale m sum) in
  let seen v = Ivec.sub (Ivec.scale k s.points.(v)) sum in
  let meets f =
    let corners = s.faces.(f) in
    let n = Array.length corners in
    let rec inside i =
      i >= n
      || Z.sign (Ivec.det ray (seen corners.(i)) (seen corners.((i + 1) mod n))) >= 0
         && inside (i + 1)
    in
    inside 0
  in
  let n = Array.length s.faces in
  let rec go f = if f >= n then None else if meets f then Some f else go (f + 1) in
  go 1

(* Two faces that one ray from behind both meets: the farther, or either at a common point, has a corner
   in front of the other, or they overlap in one plane. *)
let overlap_fault s f g =
  let behind_of a b = find_corner s.faces.(b) (fun v -> side s a v > 0) in
  match (behind_of f g, behind_of g f) with
  | Some v, _ -> Polyhedron_fault.Not_convex (f, v)
  | None, Some v -> Polyhedron_fault.Not_convex (g, v)
  | None, None ->
    let strange a b =
      find_corner s.faces.(b) (fun v -> not (Array.exists (Int.equal v) s.faces.(a)))
    in
    (match (strange f g, strange g f) with
     | Some v, _ -> Polyhedron_fault.In_plane (f, v)
     | None, Some v -> Polyhedron_fault.In_plane (g, v)
     | None, None -> Polyhedron_fault.Coplanar_neighbours (f, g))

let global_fault s =
  let sum, k = mean s in
  let n = Array.length s.faces in
  let rec not_behind f =
    if f >= n then None else if side_scaled s f k sum >= 0 then Some f else not_behind (f + 1)
  in
  match not_behind 0 with
  | Some f -> (
      match in_front s f with
      | Some v -> [ Polyhedron_fault.Not_convex (f, v) ]
      | None -> Scc_base.Bug.fail __POS__ "a flat surface was not found to be flat")
  | None -> (
      match second_hit s (sum, k) with
      | None -> []
      | Some g -> [ overlap_fault s 0 g ])

let is_flat s =
  let in_plane v = side s 0 v = 0 in
  Array.for_all (Array.for_all in_plane) s.faces

let whole_faults s across after =
  match edge_faults s across after with
  | [] -> global_fault s
  | found -> found

let faults points faces surface =
  let s = { points; faces; normals = Array.map (Face_check.normal points) faces } in
  let corner g i = faces.(g).(i mod Array.length faces.(g)) in
  match Surface.pieces surface with
  | a :: (_ :: _ as others) -> List.map (fun b -> Polyhedron_fault.Separate_solids (a, b)) others
  | [] | [ _ ] ->
    if is_flat s then [ Polyhedron_fault.Flat 0 ]
    else if Z.sign (volume6 s) < 0 then
      (* The surface knows the orientation that it was made with, in which edges and tuples run backwards. *)
      Polyhedron_fault.Inward
      :: whole_faults (turn_over s)
        (fun v w -> Surface.across surface w v)
        (fun g place -> corner g (place + Array.length faces.(g) - 1))
    else whole_faults s (Surface.across surface) (fun g place -> corner g (place + 2))
