(* Binding by contact (reading I-33) of slanted faces, against a formula. A tetrahedron and its mirror image by a
   point, of another size, touch the plane of their slanted faces from its two sides, and one slides along it.

   In the plane, with one corner of the first face as the origin and its two edges there as the unit vectors, that
   face is where x, y >= 0 and x + y <= 1. The other, of size s, has its corner at (a, b), and is where x <= a,
   y <= b and x + y >= a + b - s. They have a point in common iff a, b >= 0 and a + b <= 1 + s. *)

open Scc_exact
open Scc_semantics
open Scc_test_networks
open Scc_test_models
module Gen = QCheck2.Gen

type case = {
  corners : Vec.t list;  (** of the first tetrahedron, besides the origin; the slanted face is theirs *)
  size : Rat.t;  (** of the second one *)
  at : Rat.t * Rat.t;  (** its corner, in the plane *)
  moves : Rat.t * Rat.t;  (** by a unit of time, in the plane *)
  opens : Rat.t;  (** when the channel of the first one opens *)
}

(* {1 By the formula} *)

(* The least t >= opens at which a, b >= 0 and a + b <= 1 + s. *)
let expected c =
  let (a, b), (v, w) = (c.at, c.moves) in
  let room = Rat.sub (Rat.add Rat.one c.size) (Rat.add a b) in
  (* From here on x + t y >= 0. *)
  let clip times (x, y) =
    match (times, Rat.sign y) with
    | None, _ -> None
    | Some _, 0 -> if Rat.sign x < 0 then None else times
    | Some (first, last), s ->
      let t = Rat.neg (Rat.div x y) in
      if s > 0 then Some (Rat.max first t, last)
      else Some (first, Some (match last with None -> t | Some l -> Rat.min l t))
  in
  match List.fold_left clip (Some (c.opens, None)) [ (a, v); (b, w); (room, Rat.neg (Rat.add v w)) ] with
  | Some (first, Some last) when Rat.compare first last > 0 -> None
  | Some (first, _) -> Some first
  | None -> None

(* {1 By the model} *)

let text c =
  let vertex name v = name ^ " " ^ Vec.to_string v in
  let shape name corners order =
    let vertices = vertex "k" Vec.zero :: List.map2 vertex order corners in
    let faces = "one [k,m,l] two [k,l,n] three [k,n,m] slant [l,m,n]" in
    Printf.sprintf "shape %s {\n  vertices %s\n  faces %s\n}\n" name (String.concat "  " vertices) faces
  in
  let l, m, n = match c.corners with [ l; m; n ] -> (l, m, n) | _ -> invalid_arg "three corners" in
  let along (x, y) = Vec.axpy x (Vec.sub m l) (Vec.scale y (Vec.sub n l)) in
  let place = Vec.add (Vec.scale (Rat.add Rat.one c.size) l) (along c.at) in
  shape "One" c.corners [ "l"; "m"; "n" ]
  ^ shape "Two" (List.map (Vec.scale (Rat.neg c.size)) c.corners) [ "l"; "n"; "m" ]
  ^ Printf.sprintf
    "binding contact\n\
     process p = One mass 1 [%s<bond, {slant}>. nil]\n\
     process q = Two mass 1 velocity %s at translate %s [<~bond, {slant}>. nil]\n"
    (if Rat.sign c.opens = 0 then "" else Printf.sprintf "eps(%s). " (Rat.to_string c.opens))
    (Vec.to_string (along c.moves)) (Vec.to_string place)

(* When they bind; nothing else may happen but that time passes. *)
let found c =
  let { Scc_elaborate.Elaborate.model; declared; _ } = Load.exactly (Load.text (text c)) in
  let rec follow s time =
    match List.map (fun (t : Transition.t) -> (t.label, t.target)) (Reach.successors model s) with
    | [] -> None
    | (Bind _, _) :: _ as all ->
      let is_bind = function Transition.Bind _, _ -> true | _ -> false in
      if List.for_all is_bind all then Some time else Alcotest.fail "something else happens when they bind"
    | [ (Time d, target) ] -> follow target (Rat.add time d)
    | (label, _) :: _ -> Alcotest.fail (Transition.label_to_string model label)
  in
  follow (Reach.initial model declared) Rat.zero

(* {1 At random} *)

let show = function None -> "never" | Some t -> Rat.to_string t

let gen =
  let open Gen in
  let small = int_range (-4) 4 in
  let point = map3 Vec.of_ints small small small in
  let rational low = map2 (fun n d -> Rat.make (Z.of_int n) (Z.of_int d)) (int_range low 9) (int_range 1 4) in
  let number = rational (-9) in
  let* l = point and* m = point and* n = point in
  let volume = Rat.sign (Vec.dot l (Vec.cross m n)) in
  let corners =
    if volume > 0 then [ l; m; n ]
    else if volume < 0 then [ l; n; m ]
    else [ Vec.of_ints 3 0 1; Vec.of_ints 0 2 (-1); Vec.of_ints 1 1 4 ]
  in
  let* size = rational 1 and* at = pair number number and* moves = pair number number in
  let* opens = oneof [ return Rat.zero; rational 0 ] in
  return { corners; size; at; moves; opens }

let random =
  QCheck2.Test.make ~count:400 ~name:"I-33: slanted faces that slide into each other, by a formula" ~print:text gen
    (fun c ->
       let expected = show (expected c) and found = show (found c) in
       if String.equal expected found then true
       else QCheck2.Test.fail_reportf "%s by the formula, %s by the model" expected found)

(* They bind at first, on the way and never. *)
let kinds () =
  let rand = Stdlib.Random.State.make [| 7 |] in
  let all = List.map (fun c -> (c, expected c)) (Gen.generate ~n:400 ~rand gen) in
  let many what test = Alcotest.(check bool) what true (List.length (List.filter test all) > 30) in
  many "never" (fun (_, t) -> Option.is_none t);
  many "as soon as the channel opens" (fun (c, t) -> Option.equal Rat.equal t (Some c.opens));
  many "later" (fun (c, t) -> match t with Some t -> Rat.compare t c.opens > 0 | None -> false)

let () =
  Alcotest.run "slanted faces"
    [
      ("random", Scc_test_support.Property.cases [ random ]);
      ("cases", [ Alcotest.test_case "each kind is tried" `Quick kinds ]);
    ]
