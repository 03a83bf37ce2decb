open Scc_exact

type facet = { normal : Ivec.t; num : Z.t; den : Z.t }

(* A meets B + r iff r = a - b for some a in A and b in B, so the obstacle is the Minkowski sum of A and
   -B. For a direction n let F(K, n) be the face of K that is highest in the direction n. Faces of a sum are
   sums of faces, F(A - B, n) = F(A, n) - F(B, -n), and n is the normal of a facet iff that sum has
   dimension 2. The dimensions of the two summands leave three cases:
   1. F(A, n) is a face: n is a normal of A;
   2. F(B, -n) is a face: -n is a normal of B;
   3. both are edges and not parallel (two vertices give a vertex, an edge and a vertex an edge, parallel
      edges an edge).
   F(A, n) is the edge e exactly for the n strictly between the normals of the two faces of e: an open arc
   of the Gauss map, shorter than half a circle and not empty, because neighbours are not coplanar. So
   case 3 holds exactly where an open arc of A crosses an open arc of -B properly, and each crossing gives a
   normal of its own, since n determines the edges. Arcs that meet at an end only belong to cases 1 or 2, which
   take all normals anyway; arcs that overlap belong to parallel edges. Hence the list is complete, holds
   facets only, and repeats a direction only where a normal of A is opposite to one of B.

   The crossing test. Let e have direction d with faces of normals p, q on its left and right, so that p x q
   is a positive multiple of d; and f of B direction c with normals p', q'. A common normal is n = s (d x c)
   with s = 1 or -1. From p x (d x c) = (p.c) d for p orthogonal to d, n lies strictly between p and q iff
   sign(p.c) = s and sign(q.c) = -s; and -n strictly between p' and q' iff sign(p'.d) = s and
   sign(q'.d) = -s. Both tables of signs are computed once, and each pair of edges is four look-ups. *)

(* [signs normals directions]: for each edge the signs of the normals along it, one byte each. *)
let signs normals directions =
  let code d i = Char.unsafe_chr (1 + Z.sign (Ivec.dot normals.(i) d)) in
  Array.map (fun d -> Bytes.init (Array.length normals) (code d)) directions

let sign_at row i = Char.code (Bytes.get row i) - 1

let greatest n points =
  Array.fold_left (fun m p -> Z.max m (Ivec.dot n p)) (Ivec.dot n points.(0)) points

let least n points =
  Array.fold_left (fun m p -> Z.min m (Ivec.dot n p)) (Ivec.dot n points.(0)) points

let face_corner (s : Solid.t) f = (snd s.polyhedron.faces.(f)).(0)

module Direction_table = Hashtbl.Make (Ivec)

(* Cases 1 and 2; [va] and [vb] are the vertices over the common denominator. *)
let face_facets (a : Solid.t) va (b : Solid.t) vb facet =
  let seen = Direction_table.create (2 * Array.length a.normals) in
  let of_a f n =
    Direction_table.replace seen n ();
    facet n (Z.sub (Ivec.dot n va.(face_corner a f)) (least n vb))
  in
  let of_b f m =
    let n = Ivec.neg m in
    if Direction_table.mem seen n then None
    else Some (facet n (Z.sub (greatest n va) (Ivec.dot n vb.(face_corner b f))))
  in
  let first = Array.to_list (Array.mapi of_a a.normals) in
  first @ List.filter_map Fun.id (Array.to_list (Array.mapi of_b b.normals))

(* Case 3, in front of [facets]. *)
let edge_facets (a : Solid.t) va (b : Solid.t) vb facet facets =
  let ea = a.topology.edges and eb = b.topology.edges in
  let along_b = signs a.normals b.directions and along_a = signs b.normals a.directions in
  let found = ref facets in
  Array.iteri
    (fun i (e : Topology.edge) ->
       let row = along_a.(i) in
       Array.iteri
         (fun j (f : Topology.edge) ->
            let s = sign_at along_b.(j) e.left in
            if s <> 0
            && sign_at along_b.(j) e.right = -s
            && sign_at row f.left = s
            && sign_at row f.right = -s
            then begin
              let n = Ivec.primitive (Ivec.cross a.directions.(i) b.directions.(j)) in
              let n = if s > 0 then n else Ivec.neg n in
              found := facet n (Z.sub (Ivec.dot n va.(e.tail)) (Ivec.dot n vb.(f.tail))) :: !found
            end)
         eb)
    ea;
  !found

let over denominator (s : Solid.t) =
  let k = Z.divexact denominator s.denominator in
  if Z.equal k Z.one then s.vertices else Array.map (Ivec.scale k) s.vertices

let facets (a : Solid.t) (b : Solid.t) =
  let den = Z.lcm a.denominator b.denominator in
  let va = over den a and vb = over den b in
  let facet normal num = { normal; num; den } in
  Array.of_list (edge_facets a va b vb facet (face_facets a va b vb facet))
