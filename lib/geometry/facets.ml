open Scc_exact

type facet = Minkowski.facet = { normal : Ivec.t; num : Z.t; den : Z.t }
type t = { facets : facet array; filter : Facet_filter.t }

let make a b =
  let facets = Minkowski.facets a b in
  { facets; filter = Facet_filter.make facets }

(* {1 Queries}

   With r = p/q over the integers, n.r against num/den is n.(den p) against num q: four products for each
   facet, and no rational before the answer. *)

let facets o = o.facets
let denominator o = o.facets.(0).den

(* A line r + t w over the integers: (p + t v)/q over the denominator of the facets, and its floats. *)
type line = { p : Ivec.t; v : Ivec.t; q : Z.t; floats : Facet_filter.line }

let line o r w =
  let rw, q = Ivec.of_vecs [| r; w |] in
  let p = Ivec.scale (denominator o) rw.(0) and v = Ivec.scale (denominator o) rw.(1) in
  { p; v; q; floats = Facet_filter.line p v q }

(* The line is inside the plane of a facet while s t <= c. *)
let slack (f : facet) l = Z.sub (Z.mul f.num l.q) (Ivec.dot f.normal l.p)
let speed (f : facet) l = Ivec.dot f.normal l.v

(* The sign of the slack of facet i at time 0. *)
let side o l i =
  let s = Facet_filter.side o.filter l.floats 0. i in
  if s <> 0 then s else Z.sign (slack o.facets.(i) l)

type relation = Apart | Touching | Interpenetrating

let relation o r =
  let l = line o r Vec.zero in
  let rec scan i touching =
    if i = Array.length o.facets then if touching then Touching else Interpenetrating
    else
      let s = side o l i in
      if s < 0 then Apart else scan (i + 1) (touching || s = 0)
  in
  scan 0 false

let separating o r =
  let l = line o r Vec.zero in
  let rec scan i tight =
    if i < 0 then tight
    else
      let s = side o l i in
      if s < 0 then Scc_base.Bug.fail __POS__ "separating directions of bodies that are apart"
      else scan (i - 1) (if s = 0 then o.facets.(i).normal :: tight else tight)
  in
  match scan (Array.length o.facets - 1) [] with
  | [] -> Scc_base.Bug.fail __POS__ "separating directions of interpenetrating bodies"
  | normals -> normals

type cast = Never | Inside | At of Rat.t

(* A bound num/den with den > 0, or none. *)
type bound = Infinite | Bound of Z.t * Z.t

let less (n1, d1) (n2, d2) = Z.lt (Z.mul n1 d2) (Z.mul n2 d1)

(* The times at which a line satisfies the condition s t <= c of every facet: an upper bound for s > 0, a
   lower one for s < 0, and for s = 0 all times or none, as [still] says of the sign of c. *)
let clip o l ~still =
  let rec scan i low high =
    if i = Array.length o.facets then Some (low, high)
    else
      let c = slack o.facets.(i) l and s = speed o.facets.(i) l in
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

let cast_by_clipping o l =
  match clip o l ~still:(fun c -> c > 0) with
  | None -> Never
  | Some (Infinite, _) | Some (_, Infinite) -> Inside (* w = 0: a bounded obstacle bounds any other line *)
  | Some (Bound (n1, d1), Bound (n2, d2)) ->
    if Z.sign n2 <= 0 || not (less (n1, d1) (n2, d2)) then Never
    else if Z.sign n1 < 0 then Inside
    else At (Rat.make n1 d1)

(* Whether at the time n/d >= 0 the line is inside every facet's plane, or in the plane and entering if
   [entering] allows it. *)
let enters o l (n, d) ~entering =
  let t = Z.to_float n /. Z.to_float d in
  let inside i =
    match Facet_filter.side o.filter l.floats t i with
    | 1 -> true
    | -1 -> false
    | _ ->
      let s = speed o.facets.(i) l in
      let c = Z.sign (Z.sub (Z.mul (slack o.facets.(i) l) d) (Z.mul s n)) in
      c > 0 || (c = 0 && entering && Z.sign s < 0)
  in
  let rec scan i = i < 0 || (inside i && scan (i - 1)) in
  scan (Array.length o.facets - 1)

(* Two facets suffice to see that a line misses, and one to give the time of contact if the line is inside
   all others then. Floats guess which; what they guess is proved exactly, or else all facets are clipped:
   - a lower bound that is not less than an upper one, or an upper one <= 0, leaves no t > 0: never;
   - if the line is strictly inside all planes at 0, it is inside;
   - if at t >= 0, the lower bound of one facet, every other plane has the line strictly inside or entering,
     then the interiors meet right after t, and not before, when the line is outside that one plane. *)
let first_time_of_contact o r w =
  let l = line o r w in
  let entry, exit = Facet_filter.guess o.filter l.floats in
  if entry < 0 || exit < 0 then cast_by_clipping o l
  else
    let fe = o.facets.(entry) and fx = o.facets.(exit) in
    let d1 = Z.neg (speed fe l) and d2 = speed fx l in
    if Z.sign d1 <= 0 || Z.sign d2 <= 0 then cast_by_clipping o l
    else
      let n1 = Z.neg (slack fe l) and n2 = slack fx l in
      if Z.sign n2 <= 0 || not (less (n1, d1) (n2, d2)) then Never
      else if Z.sign n1 < 0 then
        if enters o l (Z.zero, Z.one) ~entering:false then Inside else cast_by_clipping o l
      else if enters o l (n1, d1) ~entering:true then At (Rat.make n1 d1)
      else cast_by_clipping o l

let meeting o r w =
  let rational = function Infinite -> None | Bound (n, d) -> Some (Rat.make n d) in
  match clip o (line o r w) ~still:(fun c -> c >= 0) with
  | None -> None
  | Some (Bound (n1, d1), Bound (n2, d2)) when less (n2, d2) (n1, d1) -> None
  | Some (low, high) -> Some (rational low, rational high)
