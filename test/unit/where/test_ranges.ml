(* Ranges of parameters: their texts, and their boxes at their ends. *)
open Scc_exact
open Scc_calculus
module Polyhedron = Scc_polyhedra.Polyhedron

let q n d = Rat.make (Z.of_int n) (Z.of_int d)
let at value included : Ranges.bound = { value; included }
let range name low high : Ranges.range = { name; low; high }

let x = range "x" (at Rat.zero true) (at (q 6 1) true)
let y = range "y" (at (q (-1) 2) false) (at Rat.one true)
let z = range "z" (at Rat.zero true) (at Rat.one false)

let text () =
  Alcotest.(check string) "three" "x in [0, 6], y in (-1/2, 1], z in [0, 1)" (Ranges.to_string [| x; y; z |]);
  Alcotest.(check string) "none" "" (Ranges.to_string [||]);
  Alcotest.(check (option int)) "found" (Some 1) (Ranges.find [| x; y |] "y");
  Alcotest.(check (option int)) "not found" None (Ranges.find [| x; y |] "z")

(* A point is in the box if and only if its coordinates are in the ranges: at the ends, beside them and between. *)
let box () =
  let tried = List.map (fun n -> q n 4) [ -3; -2; -1; 0; 1; 3; 4; 5; 23; 24; 25 ] in
  let ranges = [| x; y; z |] in
  let box = Ranges.box ranges in
  let check a b c =
    let expected = Ranges.(mem x a && mem y b && mem z c) in
    let name = String.concat " " (List.map Rat.to_string [ a; b; c ]) in
    Alcotest.(check bool) name expected (Polyhedron.mem box [| a; b; c |])
  in
  List.iter (fun a -> List.iter (fun b -> List.iter (check a b) tried) tried) tried

let ends () =
  let check name expected range value = Alcotest.(check bool) name expected (Ranges.mem range value) in
  check "low of x" true x Rat.zero;
  check "high of x" true x (q 6 1);
  check "low of y" false y (q (-1) 2);
  check "high of z" false z Rat.one

let suite =
  let case name test = Alcotest.test_case name `Quick test in
  ("ranges",
   [ ("ranges", [ case "text" text; case "box" box; case "ends" ends ]) ])
