open Scc_exact

type facet = { normal : Ivec.t; num : Z.t; den : Z.t }
type t = { a : Solid.t; b : Solid.t; facets : facet array }

(* {1 The facets}

   A meets B + r iff r = a - b for some a in A and b in B, so the obstacle is the Minkowski sum of A and
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

(* An edge with the faces on its left and right, and its direction. *)
type edge = { tail : int; left : int; right : int; direction : Ivec.t }

module Int_table = Hashtbl.Make (struct
    type t = int

    let equal = Int.equal
    let hash = Fun.id
  end)

let edges (s : Solid.t) =
  let p = s.polyhedron in
  let key v w = (v * Array.length p.vertices) + w in
  let face_of = Int_table.create (4 * Array.length p.edges) in
  Array.iteri
    (fun i (_, corners) ->
       let k = Array.length corners in
       Array.iteri (fun j v -> Int_table.replace face_of (key v corners.((j + 1) mod k)) i) corners)
    p.faces;
  let face v w =
    match Int_table.find_opt face_of (key v w) with
    | Some f -> f
    | None -> Scc_base.Bug.fail __POS__ "an edge of a solid has no face"
  in
  Array.map
    (fun (v, w) ->
       let direction = Ivec.primitive (Ivec.sub s.vertices.(w) s.vertices.(v)) in
       { tail = v; left = face v w; right = face w v; direction })
    p.edges

(* [signs normals edges]: for each edge the signs of the normals along it, one byte each. *)
let signs normals edges =
  let code e i = Char.unsafe_chr (1 + Z.sign (Ivec.dot normals.(i) e.direction)) in
  Array.map (fun e -> Bytes.init (Array.length normals) (code e)) edges

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
  let ea = edges a and eb = edges b in
  let along_b = signs a.normals eb and along_a = signs b.normals ea in
  let found = ref facets in
  Array.iteri
    (fun i e ->
       let row = along_a.(i) in
       Array.iteri
         (fun j f ->
            let s = sign_at along_b.(j) e.left in
            if s <> 0
            && sign_at along_b.(j) e.right = -s
            && sign_at row f.left = s
            && sign_at row f.right = -s
            then begin
              let n = Ivec.primitive (Ivec.cross e.direction f.direction) in
              let n = if s > 0 then n else Ivec.neg n in
              found := facet n (Z.sub (Ivec.dot n va.(e.tail)) (Ivec.dot n vb.(f.tail))) :: !found
            end)
         eb)
    ea;
  !found

let over denominator (s : Solid.t) =
  let k = Z.divexact denominator s.denominator in
  if Z.equal k Z.one then s.vertices else Array.map (Ivec.scale k) s.vertices

let make (a : Solid.t) (b : Solid.t) =
  let den = Z.lcm a.denominator b.denominator in
  let va = over den a and vb = over den b in
  let facet normal num = { normal; num; den } in
  let facets = edge_facets a va b vb facet (face_facets a va b vb facet) in
  { a; b; facets = Array.of_list facets }

(* {1 Queries}

   With r = p/q over the integers, n.r against num/den is n.(den p) against num q: four products for each
   facet, and no rational before the answer. *)

let denominator o = o.facets.(0).den

(* The integers den p and q of an offset. *)
let prepare o r =
  let p, q = Ivec.of_vec r in
  (Ivec.scale (denominator o) p, q)

type relation = Apart | Touching | Interpenetrating

let relation o r =
  let p, q = prepare o r in
  let rec scan i touching =
    if i = Array.length o.facets then if touching then Touching else Interpenetrating
    else
      let f = o.facets.(i) in
      let c = Z.compare (Ivec.dot f.normal p) (Z.mul f.num q) in
      if c > 0 then Apart else scan (i + 1) (touching || c = 0)
  in
  scan 0 false

let separating o r =
  let p, q = prepare o r in
  let tight f =
    let c = Z.compare (Ivec.dot f.normal p) (Z.mul f.num q) in
    if c > 0 then Scc_base.Bug.fail __POS__ "separating directions of bodies that are apart"
    else if c = 0 then Some f.normal
    else None
  in
  match List.filter_map tight (Array.to_list o.facets) with
  | [] -> Scc_base.Bug.fail __POS__ "separating directions of interpenetrating bodies"
  | normals -> normals

(* At a boundary point r of a convex polytope, r + t w is interior for all small t > 0 iff w goes strictly
   inwards through every facet that holds r. *)
let approaching o r w =
  let w, _ = Ivec.of_vec w in
  List.for_all (fun n -> Z.sign (Ivec.dot n w) < 0) (separating o r)

type cast = Never | Inside | At of Rat.t

(* A bound num/den with den > 0, or none. *)
type bound = Infinite | Bound of Z.t * Z.t

let less (n1, d1) (n2, d2) = Z.lt (Z.mul n1 d2) (Z.mul n2 d1)

(* The times at which r + t w satisfies every n.(r + t w) <= num/den. Over the common denominator of r and w
   the condition of a facet reads  s t <= c : an upper bound for s > 0, a lower one for s < 0, and for s = 0
   all times or none. [still c] says whether a facet parallel to w lets the line through. *)
let clip o r w ~still =
  let vs, q = Ivec.of_vecs [| r; w |] in
  let p = Ivec.scale (denominator o) vs.(0) and v = Ivec.scale (denominator o) vs.(1) in
  let rec scan i low high =
    if i = Array.length o.facets then Some (low, high)
    else
      let f = o.facets.(i) in
      let c = Z.sub (Z.mul f.num q) (Ivec.dot f.normal p) and s = Ivec.dot f.normal v in
      match Z.sign s with
      | 0 -> if still (Z.sign c) then scan (i + 1) low high else None
      | 1 -> (
          match high with
          | Bound (n, d) when not (less (c, s) (n, d)) -> scan (i + 1) low high
          | _ -> scan (i + 1) low (Bound (c, s)))
      | _ -> (
          let c = Z.neg c and s = Z.neg s in
          match low with
          | Bound (n, d) when not (less (n, d) (c, s)) -> scan (i + 1) low high
          | _ -> scan (i + 1) (Bound (c, s)) high)
  in
  scan 0 Infinite Infinite

let first_time_of_contact o r w =
  match clip o r w ~still:(fun c -> c > 0) with
  | None -> Never
  | Some (Infinite, _) | Some (_, Infinite) -> Inside (* w = 0: a bounded obstacle bounds any other line *)
  | Some (Bound (n1, d1), Bound (n2, d2)) ->
    if Z.sign n2 <= 0 || not (less (n1, d1) (n2, d2)) then Never
    else if Z.sign n1 < 0 then Inside
    else At (Rat.make n1 d1)

let meeting o r w =
  let rational = function Infinite -> None | Bound (n, d) -> Some (Rat.make n d) in
  match clip o r w ~still:(fun c -> c >= 0) with
  | None -> None
  | Some (Bound (n1, d1), Bound (n2, d2)) when less (n2, d2) (n1, d1) -> None
  | Some (low, high) -> Some (rational low, rational high)
