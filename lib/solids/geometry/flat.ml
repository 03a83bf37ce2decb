open Scc_exact

type point = { x : Z.t; y : Z.t }

type shape = Point of point | Segment of point * point | Polygon of point list  (** counter-clockwise about n *)

(* The affine form kx x + ky y + k. *)
type form = { kx : Z.t; ky : Z.t; k : Z.t }

let value f p = Z.add (Z.mul f.kx p.x) (Z.add (Z.mul f.ky p.y) f.k)
let through kx ky p = { kx; ky; k = Z.neg (Z.add (Z.mul kx p.x) (Z.mul ky p.y)) }

(* Positive on the left of the line from a to b. *)
let left_of a b = through (Z.sub a.y b.y) (Z.sub b.x a.x) a

(* Positive where the segment from a to b has not begun: on the side of b of the normal at a. *)
let beyond a b = through (Z.sub b.x a.x) (Z.sub b.y a.y) a

let sides ps = List.map (fun (a, b) -> left_of a b) (Scc_data.Lists.ring ps)

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

(* Two convex polygons have no inner point in common iff a side of one of them has the other on its outside. *)
let sides_part ps qs = List.exists (fun f -> List.for_all (fun q -> Z.sign (value f q) <= 0) qs) (sides ps)

let meet s t =
  match (s, t) with
  | Point p, other | other, Point p ->
    let zero, positive = forms other in
    List.for_all (fun f -> Z.sign (value f p) = 0) zero
    && List.for_all (fun f -> Z.sign (value f p) > 0) positive
  | Segment (a, b), other | other, Segment (a, b) -> Option.is_some (interval a b (forms other))
  | Polygon ps, Polygon qs -> not (sides_part ps qs || sides_part qs ps)

(* Of the intersection, for shapes whose relative interiors intersect. *)
let dimension s t =
  match (s, t) with
  | Point _, _ | _, Point _ -> 0
  | Segment (a, b), Segment (c, d) ->
    let l = left_of a b in
    if Z.equal (value l c) (value l d) then 1 else 0
  | Segment _, Polygon _ | Polygon _, Segment _ -> 1
  | Polygon _, Polygon _ -> 2

(* {1 The region of two shapes} *)

let at p q t = Vec.axpy (Rat.make t.num t.den) (Vec.sub q p) p

(* The part of a convex polygon where a form is not negative. The form is not negative on the whole of some
   inner part of the polygon, so that no corner is doubled. *)
let clip polygon form =
  let valued = List.map (fun p -> (p, form p)) polygon in
  let step ((p, s), (q, t)) =
    let crosses = Rat.sign s * Rat.sign t < 0 in
    let crossing = if crosses then [ Vec.axpy (Rat.div s (Rat.sub s t)) (Vec.sub q p) p ] else [] in
    if Rat.sign s >= 0 then p :: crossing else crossing
  in
  List.concat_map step (Scc_data.Lists.ring valued)

(* The intersection of two polygons of one plane, counter-clockwise about n, whose inner parts intersect. *)
let common n p q =
  let side a b x = Vec.dot n (Vec.cross (Vec.sub b a) (Vec.sub x a)) in
  List.fold_left (fun p (a, b) -> clip p (side a b)) p (Scc_data.Lists.ring q)

let region ~normal (s, ends_s) (t, ends_t) =
  match (s, ends_s, t, ends_t) with
  | Point _, ends, _, _ | _, _, Point _, ends -> ends
  | Segment (a, b), ends, other, _ | other, _, Segment (a, b), ends -> (
      match (interval a b (forms other), ends) with
      | Some (low, high), [ p; q ] -> if less low high then [ at p q low; at p q high ] else [ at p q low ]
      | _ -> Scc_base.Bug.fail __POS__ "the region of two shapes that do not meet")
  | Polygon _, p, Polygon _, q -> common normal p q

(* {1 Hulls} *)

let corners = function Point p -> [ p ] | Segment (p, q) -> [ p; q ] | Polygon ps -> ps

let compare_points p q =
  Z.compare p.x q.x <?> fun () -> Z.compare p.y q.y

(* The chain of true left turns through sorted points, backwards and without its last point (Andrew's monotone
   chain). *)
let chain points =
  let rec add kept p =
    match kept with
    | b :: (a :: _ as rest) when Z.sign (value (left_of a b) p) <= 0 -> add rest p
    | _ -> p :: kept
  in
  List.tl (List.fold_left add [] points)

let hull points =
  match List.sort_uniq compare_points points with
  | [] -> Scc_base.Bug.fail __POS__ "the hull of no points"
  | [ p ] -> Point p
  | sorted -> (
      match List.rev_append (chain sorted) (List.rev (chain (List.rev sorted))) with
      | [ p; q ] -> Segment (p, q)
      | ps -> Polygon ps)
