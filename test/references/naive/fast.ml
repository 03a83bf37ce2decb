open Scc_exact

(* {1 Integer vectors, on their own} *)

let dot (a : Ivec.t) (b : Ivec.t) = Z.add (Z.mul a.x b.x) (Z.add (Z.mul a.y b.y) (Z.mul a.z b.z))
let minus (a : Ivec.t) (b : Ivec.t) : Ivec.t = { x = Z.sub a.x b.x; y = Z.sub a.y b.y; z = Z.sub a.z b.z }
let times k (a : Ivec.t) : Ivec.t = { x = Z.mul k a.x; y = Z.mul k a.y; z = Z.mul k a.z }
let opposite (a : Ivec.t) : Ivec.t = { x = Z.neg a.x; y = Z.neg a.y; z = Z.neg a.z }
let is_null (a : Ivec.t) = Z.sign a.x = 0 && Z.sign a.y = 0 && Z.sign a.z = 0

let product (a : Ivec.t) (b : Ivec.t) : Ivec.t =
  let minor p q r s = Z.sub (Z.mul p s) (Z.mul q r) in
  { x = minor a.y a.z b.y b.z; y = minor a.z a.x b.z b.x; z = minor a.x a.y b.x b.y }

let order (a : Ivec.t) (b : Ivec.t) =
  let c = Z.compare a.x b.x in
  if c <> 0 then c
  else
    let c = Z.compare a.y b.y in
    if c <> 0 then c else Z.compare a.z b.z

(* The shortest integer vector along the line of another, the one of the two that is above its opposite. *)
let axis (a : Ivec.t) : Ivec.t =
  let g = Z.gcd a.x (Z.gcd a.y a.z) in
  let g = if order a (opposite a) < 0 then Z.neg g else g in
  { x = Z.divexact a.x g; y = Z.divexact a.y g; z = Z.divexact a.z g }

let common_denominator vectors =
  let add d (v : Vec.t) = Z.lcm (Z.lcm d v.x.Q.den) (Z.lcm v.y.Q.den v.z.Q.den) in
  Array.fold_left add Z.one vectors

let over d (v : Vec.t) : Ivec.t =
  let whole (q : Q.t) = Z.mul q.num (Z.divexact d q.den) in
  { x = whole v.x; y = whole v.y; z = whole v.z }

(* {1 Axes} *)

(* The solids touch along the direction where direction . r = height / den, and are apart beyond. *)
type plane = { direction : Ivec.t; height : Z.t; facet : bool }
type t = { planes : plane array; den : Z.t; a : Ivec.t array; b : Ivec.t array }

let distinct vectors =
  List.sort_uniq order (List.map axis (List.filter (fun v -> not (is_null v)) vectors))

let edge_directions s points =
  distinct (List.map (fun (v, w) -> minus points.(w) points.(v)) (Naive.edges s))

let face_normal points = function
  | p :: q :: r :: _ -> product (minus points.(q) points.(p)) (minus points.(r) points.(p))
  | _ -> invalid_arg "a face has three corners"

(* Whether vectors span at least a plane. *)
let span_a_plane vectors =
  match List.find_opt (fun v -> not (is_null v)) vectors with
  | None -> false
  | Some d -> List.exists (fun v -> not (is_null (product d v))) vectors

let indices holds heights =
  let keep i rest = if holds heights.(i) then i :: rest else rest in
  List.fold_right keep (List.init (Array.length heights) Fun.id) []

let differences points = function
  | [] -> []
  | first :: rest -> List.map (fun i -> minus points.(i) points.(first)) rest

(* Both ways along an axis: from A to B, and from B to A. *)
let both_ways a b n =
  let ha = Array.map (dot n) a and hb = Array.map (dot n) b in
  let least h = Array.fold_left Z.min h.(0) h and greatest h = Array.fold_left Z.max h.(0) h in
  let plane direction at_a at_b =
    let of_a = indices (Z.equal at_a) ha and of_b = indices (Z.equal at_b) hb in
    let height = Z.sub at_a at_b in
    { direction; height; facet = span_a_plane (differences a of_a @ differences b of_b) }
  in
  let back = plane (opposite n) (least ha) (greatest hb) in
  [ plane n (greatest ha) (least hb); { back with height = Z.neg back.height } ]

let make (s : Naive.solid) (t : Naive.solid) =
  let den = common_denominator (Array.append s.points t.points) in
  let a = Array.map (over den) s.points and b = Array.map (over den) t.points in
  let ea = edge_directions s a and eb = edge_directions t b in
  let products = List.concat_map (fun d -> List.map (product d) eb) ea in
  let normals = List.map (face_normal a) s.faces @ List.map (face_normal b) t.faces in
  let axes = distinct (List.rev_append normals products) in
  { planes = Array.of_list (List.concat_map (both_ways a b) axes); den; a; b }

let axes t = Array.length t.planes
let only_facets t = List.filter (fun p -> p.facet) (Array.to_list t.planes)
let reduce t = { t with planes = Array.of_list (only_facets t) }
let facets t = Array.of_list (List.sort order (List.map (fun p -> p.direction) (only_facets t)))

let support t n =
  let ha = Array.map (dot n) t.a and hb = Array.map (dot n) t.b in
  ( indices (Z.equal (Array.fold_left Z.max ha.(0) ha)) ha,
    indices (Z.equal (Array.fold_left Z.min hb.(0) hb)) hb )

(* {1 Queries}

   The line r + t w is (p + t v)/q over the denominator of the planes; the gap along a plane's direction at time
   t is (gap + t speed)/(q den). *)

type line = { p : Ivec.t; v : Ivec.t; q : Z.t }

let line t r w =
  let q = common_denominator [| r; w |] in
  { p = times t.den (over q r); v = times t.den (over q w); q }

let gap plane l = Z.sub (dot plane.direction l.p) (Z.mul plane.height l.q)
let speed plane l = dot plane.direction l.v

let relation t r : Naive.relation =
  let l = line t r Vec.zero in
  let greatest = Array.fold_left (fun m plane -> Int.max m (Z.sign (gap plane l))) (-1) t.planes in
  if greatest > 0 then Apart else if greatest = 0 then Touching else Interpenetrating

(* n/d with d > 0. *)
type time = { n : Z.t; d : Z.t }

let compare_times s t = Z.compare (Z.mul s.n t.d) (Z.mul t.n s.d)
let rational t = Q.make t.n t.d

(* The times between which every gap is negative, None where a gap of constant sign forbids all of them. *)
let interval t l ~parallel =
  let narrow bounds plane =
    match bounds with
    | None -> None
    | Some (low, high) ->
      let g = gap plane l and s = speed plane l in
      let tighter c bound u =
        match bound with Some b when c * compare_times b u >= 0 -> bound | _ -> Some u
      in
      if Z.sign s = 0 then if parallel (Z.sign g) then bounds else None
      else if Z.sign s > 0 then Some (low, tighter (-1) high { n = Z.neg g; d = s })
      else Some (tighter 1 low { n = g; d = Z.neg s }, high)
  in
  Array.fold_left narrow (Some (None, None)) t.planes

let first_time_of_contact t r w : Naive.cast =
  match interval t (line t r w) ~parallel:(fun s -> s < 0) with
  | None -> Never
  | Some (Some low, Some high) ->
    if compare_times low high >= 0 || Z.sign high.n <= 0 then Never
    else if Z.sign low.n < 0 then Inside
    else At (rational low)
  | Some _ -> Inside

let meeting t r w =
  match interval t (line t r w) ~parallel:(fun s -> s <= 0) with
  | None -> None
  | Some (Some low, Some high) when compare_times low high > 0 -> None
  | Some (low, high) -> Some (Option.map rational low, Option.map rational high)

let touching_planes t r =
  let l = line t r Vec.zero in
  List.filter (fun plane -> Z.sign (gap plane l) = 0) (Array.to_list t.planes)

let tight t r =
  let facets = List.filter (fun plane -> plane.facet) (touching_planes t r) in
  List.sort order (List.map (fun plane -> plane.direction) facets)

let approaching t r w =
  let l = line t r w in
  List.for_all (fun plane -> Z.sign (speed plane l) < 0) (touching_planes t r)
