open Scc_exact
open Scc_rigid
open Bodies
module Naive = Solids.Naive

(* {1 By trying all pairs of features} *)

let clamp t = Rat.max Rat.zero (Rat.min Rat.one t)

(* From a point to the nearest one of a segment. *)
let to_segment p (a, b) =
  let e = Vec.sub b a in
  let t = clamp (Rat.div (Vec.dot (Vec.sub p a) e) (Vec.norm2 e)) in
  Vec.sub (Vec.axpy t e a) p

(* From a point to its foot on the plane of a face, if that is in the face. *)
let to_face p corners =
  let k = Array.length corners in
  let side i = Vec.sub corners.((i + 1) mod k) corners.(i) in
  let n = Vec.cross (side 0) (side 1) in
  let h = Rat.div (Vec.dot n (Vec.sub corners.(0) p)) (Vec.norm2 n) in
  let d = Vec.scale h n in
  let foot = Vec.add p d in
  let inside i = Rat.sign (Vec.dot n (Vec.cross (side i) (Vec.sub foot corners.(i)))) >= 0 in
  if List.for_all inside (List.init k Fun.id) then Some d else None

(* Between the lines of two segments, if the feet are in both. *)
let between (a, b) (c, d) =
  let e = Vec.sub b a and f = Vec.sub d c in
  let n = Vec.cross e f in
  if Vec.is_zero n then None
  else
    let r = Vec.sub c a in
    let s = Rat.div (Vec.dot (Vec.cross r f) n) (Vec.norm2 n) in
    let t = Rat.div (Vec.dot (Vec.cross r e) n) (Vec.norm2 n) in
    let within t = Rat.equal t (clamp t) in
    if within s && within t then Some (Vec.scale (Rat.div (Vec.dot r n) (Vec.norm2 n)) n) else None

let faces (s : Naive.solid) = List.map (fun f -> Array.of_list (List.map (Array.get s.points) f)) s.faces
let edges (s : Naive.solid) = List.map (fun (i, j) -> (s.points.(i), s.points.(j))) (Naive.edges s)

let all_vectors a b =
  let points s = Array.to_list s.Naive.points in
  let pairs f xs ys = List.concat_map (fun x -> List.filter_map (f x) ys) xs in
  let there = pairs to_face (points a) (faces b) @ pairs (fun p e -> Some (to_segment p e)) (points a) (edges b)
  and back = pairs to_face (points b) (faces a) @ pairs (fun p e -> Some (to_segment p e)) (points b) (edges a) in
  there @ List.map Vec.neg back @ pairs between (edges a) (edges b)

let by_trying a b =
  match Naive.relation a b with
  | Touching | Interpenetrating -> Vec.zero
  | Apart ->
    let shorter p q = if Rat.compare (Vec.norm2 q) (Vec.norm2 p) < 0 then q else p in
    let all = all_vectors a b in
    List.fold_left shorter (List.hd all) all

let same_as_trying (a, b) =
  Vec.equal
    (Closest.vector (Placed.vertices a) (Placed.vertices b))
    (by_trying (plain a) (plain b))

let property name ~count gen f = QCheck2.Test.make ~name ~count ~print:show_pair gen f

let anywhere = Gen.pair (placed turn (Gen.return Vec.zero)) (placed turn halves)
let aligned = Gen.pair (placed square_turn (Gen.return Vec.zero)) (placed square_turn halves)
let apart a b = Naive.relation (plain a) (plain b) = Apart

(* x.(q - p) >= x.x: no pair of points is nearer. *)
let is_optimal (a, b) =
  let va = Placed.vertices a and vb = Placed.vertices b in
  let x = Closest.vector va vb in
  Array.for_all
    (fun p -> Array.for_all (fun q -> Rat.compare (Vec.dot x (Vec.sub q p)) (Vec.norm2 x) >= 0) vb)
    va

let symmetric (a, b) =
  let va = Placed.vertices a and vb = Placed.vertices b in
  Vec.equal (Closest.vector va vb) (Vec.neg (Closest.vector vb va))

let touching =
  QCheck2.Test.make ~name:"zero for solids that touch" ~count:75
    ~print:(function Some p -> show_pair p | None -> "none")
    touching_pair
    (function
      | None -> true
      | Some (a, b) -> Vec.is_zero (Closest.vector (Placed.vertices a) (Placed.vertices b)))

let interpenetrating =
  property "zero iff the closed sets meet" ~count:100 anywhere (fun (a, b) ->
      Bool.equal (apart a b) (not (Vec.is_zero (Closest.vector (Placed.vertices a) (Placed.vertices b)))))

(* {1 Known distances} *)

let few () =
  let check what expected a b =
    Alcotest.(check string) what expected (Vec.to_string (Closest.vector (Array.of_list a) (Array.of_list b)))
  in
  check "points" "(1, 2, 3)" [ v 1 1 1 ] [ v 2 3 4 ];
  check "a point and a segment" "(0, 1, 0)" [ v 0 0 0 ] [ v (-1) 1 0; v 2 1 0 ];
  check "crossing segments" "(0, 0, 2)" [ v (-1) 0 0; v 1 0 0 ] [ v 0 (-1) 2; v 0 1 2 ];
  check "parallel segments" "(0, 1, 1)" [ v 0 0 0; v 4 0 0 ] [ v 3 1 1; v 9 1 1 ];
  check "one segment twice" "(0, 0, 0)" [ v 0 0 0; v 4 0 0 ] [ v 0 0 0; v 4 0 0 ];
  check "a point over a triangle" "(0, 0, -1)" [ v 1 1 1 ] [ v 0 0 0; v 3 0 0; v 0 3 0 ];
  check "the same point often" "(0, 0, -1)" [ v 1 1 1; v 1 1 1 ] [ v 0 0 0; v 0 0 0; v 3 0 0; v 0 3 0; v 3 3 0 ]

let suite =
  ("closest",
   [ ("known", [ Alcotest.test_case "few points" `Quick few ]);
     ( "properties",
       Scc_test_support.Property.cases
         [ property "the least over all pairs of features" ~count:75 anywhere same_as_trying;
           property "also for aligned solids" ~count:75 aligned same_as_trying;
           property "no two points are nearer" ~count:500 anywhere is_optimal;
           property "from B to A it is the opposite" ~count:250 aligned symmetric; touching;
           interpenetrating ] ) ])
