open Scc_exact
open Scc_geometry
open Scc_polyhedra
open Scc_rigid

type side = { solid : Solid.t; feature : Feature.t }

module Made = Scc_data.Once.Make (struct
    type t = side * side

    let same a b = Int.equal a.solid.id b.solid.id && Feature.equal a.feature b.feature
    let equal (a, b) (a', b') = same a a' && same b b'
    let one { solid; feature } = (31 * solid.id) + Feature.hash feature
    let hash (a, b) = (65599 * one a) + one b
  end)

let corners { solid; feature } =
  Placed.corners { Placed.solid; turned = Quaternion.identity; at = Vec.zero } feature

(* n . (p - a), for a point p of the space of dimension [n] whose coordinates are variables from [first] on. *)
let beyond n ~first (normal : Vec.t) a =
  Linear.of_terms n
    ~constant:(Rat.neg (Vec.dot normal a))
    [ (first, normal.x); (first + 1, normal.y); (first + 2, normal.z) ]

(* Two directions that, together with [d], span space, and are orthogonal to it. *)
let across (d : Vec.t) =
  let off = if Rat.sign d.x = 0 && Rat.sign d.y = 0 then Vec.of_ints 1 0 0 else Vec.of_ints 0 0 1 in
  let u = Vec.cross d off in
  (u, Vec.cross d u)

(* The relative interior of a feature: the constraints on a point of it. *)
let interior n ~first side =
  let zero = Linear.constant n Rat.zero in
  let equal normal a = Constraint.equals (beyond n ~first normal a) zero in
  let inside normal a = Constraint.greater (beyond n ~first normal a) zero in
  match corners side with
  | [] -> Scc_base.Bug.fail __POS__ "a feature without corners"
  | [ a ] -> [ equal (Vec.of_ints 1 0 0) a; equal (Vec.of_ints 0 1 0) a; equal (Vec.of_ints 0 0 1) a ]
  | [ a; b ] ->
    let d = Vec.sub b a in
    let u, v = across d in
    [ equal u a; equal v a; inside d a; inside (Vec.neg d) b ]
  | a :: _ as polygon ->
    let sides = Scc_data.Lists.ring polygon in
    let normal = List.fold_left (fun sum (p, q) -> Vec.add sum (Vec.cross p q)) Vec.zero sides in
    equal normal a :: List.map (fun (p, q) -> inside (Vec.cross normal (Vec.sub q p)) p) sides

(* Over a point p of the first feature, and the offset r at which p is the point p - r of the second. *)
let difference (one, two) =
  let of_second = interior 3 ~first:0 two in
  let less i = Linear.sub (Linear.variable 6 i) (Linear.variable 6 (i + 3)) in
  let at_second = List.map (fun c -> Constraint.substitute c ~dimension:6 (Array.init 3 less)) of_second in
  let both = Polyhedron.of_constraints 6 (interior 6 ~first:0 one @ at_second) in
  Polyhedron.project both [| 3; 4; 5 |]

(* {1 Dimensions} *)

let directions side =
  match corners side with
  | [] -> []
  | a :: rest -> List.map (fun b -> Vec.sub b a) rest

let rank vectors =
  match List.filter (fun v -> not (Vec.is_zero v)) vectors with
  | [] -> 0
  | d :: rest -> (
      match List.find_opt (fun n -> not (Vec.is_zero n)) (List.map (Vec.cross d) rest) with
      | None -> 1
      | Some n -> if List.for_all (fun v -> Rat.sign (Vec.dot n v) = 0) rest then 2 else 3)

let dimension_of_both (one, two) =
  let d = directions one and e = directions two in
  rank d + rank e - rank (d @ e)

(* {1 By memory} *)

type memory = { differences : Polyhedron.t Made.t; dimensions : int Made.t }

let create () = { differences = Made.create difference; dimensions = Made.create dimension_of_both }
let touching memory one two = Made.find memory.differences (one, two)
let dimension memory one two = Made.find memory.dimensions (one, two)
