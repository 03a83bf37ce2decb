open Scc_exact

type t = Minkowski.facet array

let make = Minkowski.facets
let facets o = o

(* A line r + t w over the integers: (p + t v)/q over the denominator of the facets. With it, n.r against num/den
   is n.p against num q: four products for each facet, and no rational before the answer. *)
type line = { p : Ivec.t; v : Ivec.t; q : Z.t }

let line (o : t) r w =
  let rw, q = Ivec.of_vecs [| r; w |] in
  { p = Ivec.scale o.(0).den rw.(0); v = Ivec.scale o.(0).den rw.(1); q }

(* The line is inside the plane of a facet while s t <= c. *)
let slack (f : Minkowski.facet) l = Z.sub (Z.mul f.num l.q) (Ivec.dot f.normal l.p)
let speed (f : Minkowski.facet) l = Ivec.dot f.normal l.v

type relation = Apart | Touching | Interpenetrating

let relation o r =
  let l = line o r Vec.zero in
  let rec scan i touching =
    if i = Array.length o then if touching then Touching else Interpenetrating
    else
      let room = Z.sign (slack o.(i) l) in
      if not (Side.holds Side.contact room) then Apart
      else scan (i + 1) (touching || not (Side.holds Side.overlap room))
  in
  scan 0 false

let separating o r =
  let l = line o r Vec.zero in
  let rec scan i tight =
    if i < 0 then tight
    else
      match Z.sign (slack o.(i) l) with
      | 0 -> scan (i - 1) (o.(i).normal :: tight)
      | s ->
        if s < 0 then Scc_base.Bug.fail __POS__ "separating directions of bodies that are apart"
        else scan (i - 1) tight
  in
  match scan (Array.length o - 1) [] with
  | [] -> Scc_base.Bug.fail __POS__ "separating directions of interpenetrating bodies"
  | normals -> normals

type cast = Never | Inside | At of Rat.t

(* A bound num/den with den > 0, or none. *)
type bound = Infinite | Bound of Z.t * Z.t

let less (n1, d1) (n2, d2) = Z.lt (Z.mul n1 d2) (Z.mul n2 d1)

(* The times at which a line has the room that is needed at every facet, without their bounds. *)
let clip o l need =
  let rec scan i low high =
    if i = Array.length o then Some (low, high)
    else
      let c = slack o.(i) l and s = speed o.(i) l in
      match Side.times ~speed:(Z.sign s) with
      | Always_or_never -> if Side.holds need (Z.sign c) then scan (i + 1) low high else None
      | Until -> (
          match high with
          | Bound (n, d) when not (less (c, s) (n, d)) -> scan (i + 1) low high
          | _ -> scan (i + 1) low (Bound (c, s)))
      | From -> (
          let c = Z.neg c and s = Z.neg s in
          match low with
          | Bound (n, d) when not (less (n, d) (c, s)) -> scan (i + 1) low high
          | _ -> scan (i + 1) (Bound (c, s)) high)
  in
  scan 0 Infinite Infinite

let first_time_of_contact o r w =
  match clip o (line o r w) Side.overlap with
  | None -> Never
  | Some (Infinite, _) | Some (_, Infinite) -> Inside (* w = 0: a bounded obstacle bounds any other line *)
  | Some (Bound (n1, d1), Bound (n2, d2)) ->
    if Z.sign n2 <= 0 || not (less (n1, d1) (n2, d2)) then Never
    else if Z.sign n1 < 0 then Inside
    else At (Rat.make n1 d1)

let meeting o r w =
  let rational = function Infinite -> None | Bound (n, d) -> Some (Rat.make n d) in
  match clip o (line o r w) Side.contact with
  | None -> None
  | Some (Bound (n1, d1), Bound (n2, d2)) when less (n2, d2) (n1, d1) -> None
  | Some (low, high) -> Some (rational low, rational high)
