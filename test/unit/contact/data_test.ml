open Scc_exact
open Scc_geometry
module Data = Scc_test_data.Test_data

let path name = "../../data/geometry/" ^ name

(* Every cast of a data set, with an obstacle of its own. *)
let casts shape pairs answers () =
  let plain = Data.shape (path shape) in
  let a = Data.solid ~id:0 plain Mat.identity in
  let expected = Data.lines (path answers) in
  let cases = Data.pairs (path pairs) in
  Alcotest.(check int) "as many answers as pairs" (Array.length cases) (Array.length expected);
  Array.iteri
    (fun i (c : Data.case) ->
       let b = Solid.make ~id:1 a.polyhedron c.turn in
       let found = Data.answer (Obstacle.make a b) c.far c.velocity in
       if not (String.equal found expected.(i)) then
         Alcotest.failf "%s, pair %d: found %s instead of %s" pairs (i + 1) found expected.(i))
    cases

let kissing () =
  let plain = Data.shape (path "cube.txt") in
  let cube = Data.solid ~id:0 plain Mat.identity in
  let cases = Data.kissing (path "kiss.txt") in
  Alcotest.(check int) "pairs" 1000 (Array.length cases);
  Array.iteri
    (fun i (turn, offset) ->
       let a = Solid.make ~id:0 cube.polyhedron turn and b = Solid.make ~id:1 cube.polyhedron turn in
       let o = Obstacle.make a b in
       let name what = Printf.sprintf "pair %d: %s" (i + 1) what in
       Alcotest.(check bool) (name "touch") true (Obstacle.relation o offset = Touching);
       Alcotest.(check int) (name "facets") 6 (Array.length (Obstacle.facets o));
       Alcotest.(check int) (name "dimension") 2 (Contact.highest o offset).dimension)
    cases

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("data sets",
   [ ( "casts",
       [ case "cubes" (casts "cube.txt" "pairs_cube.txt" "answers_cube.txt");
         case "aligned cubes" (casts "cube.txt" "pairs_deg.txt" "answers_deg.txt");
         case "hulls of 50 faces" (casts "poly50.txt" "pairs_poly.txt" "answers_poly.txt") ] );
     ("contacts", [ case "kissing cubes" kissing ]) ])
