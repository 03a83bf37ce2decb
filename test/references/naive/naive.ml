open Scc_exact

type solid = { points : Vec.t array; faces : int list list }

let move m d s = { s with points = Array.map (fun p -> Vec.add (Mat.apply m p) d) s.points }

let rec cyclic_pairs first = function
  | [] -> []
  | [ last ] -> [ (last, first) ]
  | a :: (b :: _ as rest) -> (a, b) :: cyclic_pairs first rest

let compare_edge (a, b) (c, d) = if Int.equal a c then Int.compare b d else Int.compare a c

let edges s =
  let unordered (a, b) = (Int.min a b, Int.max a b) in
  let of_face f = List.map unordered (cyclic_pairs (List.hd f) f) in
  List.sort_uniq compare_edge (List.concat_map of_face s.faces)

let face_normal s = function
  | a :: b :: c :: _ ->
    Vec.cross (Vec.sub s.points.(b) s.points.(a)) (Vec.sub s.points.(c) s.points.(a))
  | _ -> invalid_arg "a face has three corners"

(* Two convex polyhedra are separated, if at all, along the normal of a face or a product of two edges. *)
let axes a b =
  let direction s (v, w) = Vec.sub s.points.(w) s.points.(v) in
  let da = List.map (direction a) (edges a) and db = List.map (direction b) (edges b) in
  let crosses = List.concat_map (fun d -> List.map (Vec.cross d) db) da in
  let normals = List.map (face_normal a) a.faces @ List.map (face_normal b) b.faces in
  List.filter (fun n -> not (Vec.is_zero n)) (normals @ crosses)

let extent n s =
  let h = Array.map (Vec.dot n) s.points in
  (Array.fold_left Rat.min h.(0) h, Array.fold_left Rat.max h.(0) h)

(* For each axis, both ways: n and the gap along it from A to B (negative when they overlap there). *)
let gaps a b =
  List.concat_map
    (fun n ->
       let la, ha = extent n a and lb, hb = extent n b in
       [ (n, Rat.sub lb ha); (Vec.neg n, Rat.sub la hb) ])
    (axes a b)

type relation = Apart | Touching | Interpenetrating

let relation a b =
  let signs = List.map (fun (_, g) -> Rat.sign g) (gaps a b) in
  if List.exists (fun s -> s > 0) signs then Apart
  else if List.exists (fun s -> s = 0) signs then Touching
  else Interpenetrating

type cast = Never | Inside | At of Rat.t

(* At time t the gap along n is g + t n.w. *)
let interval a b w ~parallel =
  let narrow bounds (n, g) =
    match bounds with
    | None -> None
    | Some (low, high) ->
      let s = Vec.dot n w in
      if Rat.sign s = 0 then if parallel (Rat.sign g) then bounds else None
      else
        let t = Rat.div (Rat.neg g) s in
        let tighter choose = function None -> Some t | Some u -> Some (choose t u) in
        if Rat.sign s > 0 then Some (low, tighter Rat.min high) else Some (tighter Rat.max low, high)
  in
  List.fold_left narrow (Some (None, None)) (gaps a b)

let first_time_of_contact a b w =
  match interval a b w ~parallel:(fun s -> s < 0) with
  | None -> Never
  | Some (Some low, Some high) ->
    if Rat.compare low high >= 0 || Rat.sign high <= 0 then Never
    else if Rat.sign low < 0 then Inside
    else At low
  | Some _ -> Inside

let meeting a b w =
  match interval a b w ~parallel:(fun s -> s <= 0) with
  | Some (Some low, Some high) when Rat.compare low high > 0 -> None
  | found -> found

(* {1 Dimensions} *)

(* A basis of the span, of at most three vectors. *)
let basis vectors =
  let add basis v =
    match basis with
    | [] -> if Vec.is_zero v then [] else [ v ]
    | [ a ] -> if Vec.is_zero (Vec.cross a v) then basis else [ v; a ]
    | [ b; a ] -> if Rat.sign (Vec.dot v (Vec.cross a b)) = 0 then basis else [ v; b; a ]
    | _ -> basis
  in
  List.fold_left add [] vectors

let rank vectors = List.length (basis vectors)

let differences = function
  | [] -> []
  | p :: rest -> List.map (fun q -> Vec.sub q p) rest

let highest n s =
  let _, top = extent n s in
  List.filter (fun p -> Rat.equal (Vec.dot n p) top) (Array.to_list s.points)

let facets a b =
  let is_facet n = rank (differences (highest n a) @ differences (highest (Vec.neg n) b)) = 2 in
  List.filter is_facet (List.map fst (gaps a b))

(* {1 Relative interiors}

   Those of conv P and conv Q intersect iff 0 lies in that of conv S, for S the differences p - q, and this
   iff the cone of S is all of its span L. Otherwise a face of the cone that spans a hyperplane of L gives an
   n in L, orthogonal to dim L - 1 independent elements of S, with n.s >= 0 for all s. *)
let relative_interiors_meet p q =
  let s = List.concat_map (fun a -> List.map (Vec.sub a) q) p in
  let candidates =
    match basis s with
    | [] -> []
    | [ a ] -> [ a ]
    | [ a; b ] -> List.map (Vec.cross (Vec.cross a b)) s
    | _ -> List.concat_map (fun a -> List.map (Vec.cross a) s) s
  in
  let one_sided n =
    let signs = List.map (fun v -> Rat.sign (Vec.dot n v)) s in
    List.for_all (fun x -> x >= 0) signs || List.for_all (fun x -> x <= 0) signs
  in
  not (List.exists (fun n -> (not (Vec.is_zero n)) && one_sided n) candidates)

let features s =
  List.init (Array.length s.points) (fun i -> [ i ])
  @ List.map (fun (v, w) -> [ v; w ]) (edges s)
  @ List.map (List.sort Int.compare) s.faces

let touching a b =
  let located s = List.map (fun f -> (f, List.map (Array.get s.points) f)) (features s) in
  let fb = located b in
  let pair (f, p) (g, q) =
    if relative_interiors_meet p q then
      let dp = differences p and dq = differences q in
      Some (f, g, rank dp + rank dq - rank (dp @ dq))
    else None
  in
  List.concat_map (fun x -> List.filter_map (pair x) fb) (located a)

(* {1 Convex hulls} *)

(* The corners of the convex polygon spanned by points of one plane with the normal n, counter-clockwise:
   from each corner to the one that has all the others on its left, the farther one of those in line. *)
let polygon n points =
  let left p q x = Rat.sign (Vec.dot n (Vec.cross (Vec.sub q p) (Vec.sub x p))) in
  let next p =
    let better q x =
      let s = left p q x in
      let farther = Rat.compare (Vec.norm2 (Vec.sub x p)) (Vec.norm2 (Vec.sub q p)) > 0 in
      if s < 0 || (s = 0 && farther) then x else q
    in
    match List.filter (fun q -> not (Vec.equal p q)) points with
    | first :: rest -> List.fold_left better first rest
    | [] -> p
  in
  let start = List.fold_left (fun p q -> if Vec.compare q p < 0 then q else p) (List.hd points) points in
  let rec go p corners = if Vec.equal p start then List.rev corners else go (next p) (p :: corners) in
  go (next start) [ start ]

let triples xs =
  List.concat_map (fun a -> List.concat_map (fun b -> List.map (fun c -> (a, b, c)) xs) xs) xs

let hull points =
  let points = List.sort_uniq Vec.compare points in
  let plane (a, b, c) =
    let n = Vec.cross (Vec.sub b a) (Vec.sub c a) in
    let height p = Rat.sign (Vec.dot n (Vec.sub p a)) in
    if Vec.is_zero n || List.exists (fun p -> height p > 0) points then None
    else Some (polygon n (List.filter (fun p -> height p = 0) points))
  in
  let rec compare_lists p q =
    match (p, q) with
    | [], [] -> 0
    | [], _ -> -1
    | _, [] -> 1
    | a :: p, b :: q -> if Vec.equal a b then compare_lists p q else Vec.compare a b
  in
  let faces = List.sort_uniq compare_lists (List.filter_map plane (triples points)) in
  let corners = Array.of_list (List.sort_uniq Vec.compare (List.concat faces)) in
  let index p =
    let rec go i = if Vec.equal corners.(i) p then i else go (i + 1) in
    go 0
  in
  { points = corners; faces = List.map (List.map index) faces }
