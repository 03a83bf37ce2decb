(* Sets of parameters whose measure is known by hand, and random ones. *)
open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_regions

let q n d = Rat.make (Z.of_int n) (Z.of_int d)

let range ?(low = true) ?(high = true) name a b : Ranges.range =
  { name; low = { value = a; included = low }; high = { value = b; included = high } }

let whole name a b = range name (q a 1) (q b 1)

(* [form n c [a0; a1]]: c + a0 x0 + a1 x1, over n variables. *)
let form n constant coefficients =
  Linear.of_terms n ~constant:(q constant 1) (List.mapi (fun i a -> (i, q a 1)) coefficients)

let zero n = Linear.constant n Rat.zero
let negative n constant coefficients = Constraint.less (form n constant coefficients) (zero n)
let not_positive n constant coefficients = Constraint.at_most (form n constant coefficients) (zero n)
let is_zero n constant coefficients = Constraint.equals (form n constant coefficients) (zero n)
let set n pieces = Union.of_polyhedra n (List.map (Polyhedron.of_constraints n) pieces)

let box ranges = Union.of_polyhedron (Ranges.box ranges)

(* It fails in the rest of the box. *)
let decided ranges ~holds =
  let holds = Where.tidy (Union.inter (box ranges) holds) in
  Where.make ranges ~holds ~fails:(Union.difference (box ranges) holds)

(* It holds everywhere, or nowhere. *)
let of_test ranges truth =
  let n = Array.length ranges in
  decided ranges ~holds:(if truth then Union.universe n else Union.empty n)

let text (w : Where.t) u =
  let name = Ranges.name w.ranges in
  String.concat " or " (List.map (fun p -> "(" ^ Text.polyhedron ~name p ^ ")") (Union.pieces u))

(* Violated invariants: sets that overlap, or that do not cover exactly the box. *)
let faults (w : Where.t) =
  let sets = [ ("holds", w.holds); ("fails", w.fails); ("unknown", w.unknown) ] in
  let overlap p q = not (Polyhedron.disjoint p q) in
  let rec pairs = function [] -> false | p :: rest -> List.exists (overlap p) rest || pairs rest in
  let within (name, u) = if pairs (Union.pieces u) then [ "pieces where it is '" ^ name ^ "' overlap" ] else [] in
  let all = List.concat_map (fun (_, u) -> Union.pieces u) sets in
  List.concat_map within sets
  @ (if pairs all then [ "pieces overlap" ] else [])
  @
  if Union.equal (Union.union w.holds (Union.union w.fails w.unknown)) (box w.ranges) then []
  else [ "the sets together are not the box" ]

(* |x_i| < a *)
let within n i a =
  let unit k = List.init n (fun j -> if j = i then k else 0) in
  [ negative n (-a) (unit 1); negative n (-a) (unit (-1)) ]

(* Case 1 of two cubes that meet: y and z in [-5, 5], |y| < 2 and |z| < 2: 16 of 100. *)
let cubes =
  let ranges = [| whole "y" (-5) 5; whole "z" (-5) 5 |] in
  decided ranges ~holds:(set 2 [ within 2 0 2 @ within 2 1 2 ])

(* An octahedron and a cube: |y|, |z| < 2 and |y| + |z| < 3, given as four overlapping parts: 14 of 36. *)
let octahedron =
  let ranges = [| whole "y" (-3) 3; whole "z" (-3) 3 |] in
  let part sy sz = within 2 0 2 @ within 2 1 2 @ [ not_positive 2 0 [ -sy; 0 ]; not_positive 2 0 [ 0; -sz ] ] in
  let cut sy sz = part sy sz @ [ negative 2 (-3) [ sy; sz ] ] in
  decided ranges ~holds:(set 2 [ cut 1 1; cut 1 (-1); cut (-1) 1; cut (-1) (-1) ])

(* Two ligands at one pocket: s and t in [0, 6], the first possibly binds where 2s + 2 <= t, surely where <: 4 of
   36. *)
let ligands = [| whole "s" 0 6; whole "t" 0 6 |]
let possibly = decided ligands ~holds:(set 2 [ [ not_positive 2 2 [ 2; -1 ] ] ])
let surely = decided ligands ~holds:(set 2 [ [ negative 2 2 [ 2; -1 ] ] ])

(* Only where both come at once. *)
let tie = decided ligands ~holds:(set 2 [ [ is_zero 2 2 [ 2; -1 ] ] ])

(* {1 At random} *)

module G = QCheck2.Gen

let random_constraint n =
  let open G in
  let* coefficients = list_repeat n (int_range (-2) 2) in
  let* constant = int_range (-3) 3 in
  let* kind = int_range 0 4 in
  return
    (match kind with
     | 0 | 1 -> negative n constant coefficients
     | 2 | 3 -> not_positive n constant coefficients
     | _ -> is_zero n constant coefficients)

let random_polyhedron n = G.map (Polyhedron.of_constraints n) G.(list_size (int_range 1 4) (random_constraint n))
let random_union n = G.map (Union.of_polyhedra n) G.(list_size (int_range 0 3) (random_polyhedron n))

let random_ranges n =
  let open G in
  let name i = String.make 1 "xyzuvw".[i] in
  let* ends = list_repeat n (quad (int_range (-3) 0) (int_range 1 3) bool bool) in
  return
    (Array.of_list
       (List.mapi (fun i (a, b, low, high) -> range ~low ~high (name i) (q a 1) (q b 1)) ends))

(* What holds, what fails and what is left, with the sets that it was made of. *)
let random_where n =
  let open G in
  let* ranges = random_ranges n in
  let* holds = random_union n in
  let* fails = random_union n in
  let* known = bool in
  let w =
    if known then decided ranges ~holds else Where.make ranges ~holds ~fails:(Union.difference fails holds)
  in
  return (w, holds, if known then Union.difference (Union.universe n) holds else Union.difference fails holds)

let all w = Union.union w.Where.holds (Union.union w.fails w.unknown)

let print (w, _, _) =
  let text u = text w u in
  String.concat " | " [ Ranges.to_string w.ranges; text w.holds; text w.fails; text w.unknown ]
