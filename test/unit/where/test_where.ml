(* Sets of parameters: what they are made of, their measure and their probability. *)
open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_regions
open Where_samples.Samples
module G = QCheck2.Gen

let check_rat name expected found = Alcotest.(check string) name expected (Rat.to_string found)

let check_exactly name expected w =
  match Where.probability w with
  | Exactly x -> check_rat name expected x
  | Between _ | Not_computed -> Alcotest.fail (name ^ ": not exact")

let measure u = Option.get (Where.measure u)
let finite = function Volume.Finite x -> x | Infinite | Not_computed -> Alcotest.fail "no volume"

let volume u = Volume.sum (List.map Volume.of_polyhedron (Union.pieces (Union.disjoint u)))
let count u = List.length (Union.pieces u)

let by_hand () =
  check_exactly "two cubes" "4/25" cubes;
  check_rat "their measure" "16" (measure cubes.holds);
  check_exactly "octahedron and cube" "7/18" octahedron;
  Alcotest.(check int) "its overlapping parts are one piece" 1 (count octahedron.holds);
  check_exactly "ligands, possibly" "1/9" possibly;
  check_exactly "ligands, surely" "1/9" surely;
  check_exactly "ligands at once" "0" tie;
  Alcotest.(check int) "which is not empty" 1 (count tie.holds);
  List.iter
    (fun w -> Alcotest.(check (list string)) "faults" [] (faults w))
    [ cubes; octahedron; possibly; surely; tie ];
  let line = Union.difference possibly.holds surely.holds in
  Alcotest.(check bool) "they differ by the tie" true (Union.equal line tie.holds)

let without_parameters () =
  check_exactly "holds" "1" (of_test [||] true);
  check_exactly "fails" "0" (of_test [||] false);
  Alcotest.(check (list string)) "faults" [] (faults (of_test [||] true))

let unknown () =
  let ranges = [| whole "x" 0 4 |] in
  let upto a = set 1 [ [ not_positive 1 (-a) [ 1 ] ] ] and from a = set 1 [ [ negative 1 a [ -1 ] ] ] in
  let w = Where.make ranges ~holds:(upto 1) ~fails:(from 2) in
  (match Where.probability w with
   | Between (low, high) ->
     check_rat "low" "1/4" low;
     check_rat "high" "1/2" high
   | Exactly _ | Not_computed -> Alcotest.fail "a part is unknown");
  (* only x = 1 is unknown, which changes no probability *)
  let w = Where.make ranges ~holds:(set 1 [ [ negative 1 (-1) [ 1 ] ] ]) ~fails:(from 1) in
  check_exactly "without x = 1" "1/4" w;
  Alcotest.(check int) "which is told" 1 (count w.unknown)

let refused () =
  let bug name make =
    match make () with
    | (_ : Where.t) -> Alcotest.fail (name ^ " is accepted")
    | exception Scc_base.Bug.Bug _ -> ()
  in
  let ranges = [| whole "x" 0 4 |] in
  bug "what holds and fails" (fun () ->
      Where.make ranges ~holds:(set 1 [ [ not_positive 1 (-1) [ 1 ] ] ])
        ~fails:(set 1 [ [ not_positive 1 1 [ -1 ] ] ]));
  bug "a point" (fun () -> of_test [| whole "x" 2 2 |] true)

(* {1 At random} *)

let with_dimension make = G.(int_range 1 3 >>= make)

let law name ?(count = 150) gen print holds = QCheck2.Test.make ~name ~count ~print gen holds

let parts =
  law "disjoint parts that cover the box" (with_dimension random_where) print (fun (w, _, _) ->
      faults w = [])

let same_sets =
  law "the sets that were given, in the box" (with_dimension random_where) print (fun (w, holds, fails) ->
      let box = Union.of_polyhedron (Ranges.box w.ranges) in
      Union.equal w.holds (Union.inter box holds) && Union.equal w.fails (Union.inter box fails))

let no_two_convex =
  law "no two pieces are together convex" (with_dimension random_where) print (fun (w, _, _) ->
      let single u =
        let pieces = Union.pieces u in
        List.for_all
          (fun p -> List.for_all (fun q -> p == q || Envelope.merge p q = None) pieces)
          pieces
      in
      single w.holds && single w.fails && single w.unknown)

(* Measures add up, by the volumes of the sets as they were given. *)
let measures =
  law "measures add up" (with_dimension random_where) print (fun (w, holds, _) ->
      let box = Union.of_polyhedron (Ranges.box w.ranges) in
      let sum =
        Rat.add (measure w.holds) (Rat.add (measure w.fails) (measure w.unknown))
      in
      Rat.equal sum (Where.whole w)
      && Rat.equal (measure w.holds) (finite (volume (Union.inter box holds))))

(* The order of disjoint pieces does not depend on the order in which they come. *)
let ordered =
  law "one order" (with_dimension random_where) print (fun (w, _, _) ->
      let pieces = Union.pieces w.holds in
      let again = Where.order (List.rev pieces) in
      List.length again = List.length pieces && List.for_all2 Polyhedron.equal again pieces)

(* {1 Decimals} *)

let decimals () =
  let check f name expected x = Alcotest.(check string) name expected (f x) in
  let power n = Q.of_bigint (Z.pow (Z.of_int 10) n) in
  let tiny = Rat.div Rat.one (power 300) in
  let fixed = check (Decimal.fixed ~places:2) in
  fixed "half up" "0.13" (q 1 8);
  fixed "away from 0" "-0.13" (q (-1) 8);
  fixed "zeros are left out" "2.5" (q 5 2);
  fixed "to an integer" "3" (q 2999 1000);
  fixed "minus 0 is 0" "0" (q (-1) 1000);
  fixed "hundreds" "1200" (q 1200 1);
  let significant = check (Decimal.significant ~digits:4) in
  significant "a third" "0.3333" (q 1 3);
  significant "two thirds" "-0.6667" (q (-2) 3);
  significant "small" "0.001235" (q 12345 10000000);
  significant "smaller" "1e-300" tiny;
  significant "small digits" "1.235e-7" (q 12345 100000000000);
  significant "rounded to a power" "1" (q 99999 100000);
  significant "small, rounded to a power" "1e-6" (q 99999 100000000000);
  significant "great" "123500" (q 123456 1);
  significant "greater" "1.235e11" (q 123456789012 1);
  significant "nothing" "0" Rat.zero;
  let above = check (Decimal.significant_above ~digits:4) in
  above "a third, rounded up" "0.3334" (q 1 3);
  above "four digits as they are" "0.1234" (q 1234 10000);
  above "up to a power" "1" (q 99991 100000);
  let exact name expected x = Alcotest.(check (option string)) name expected (Decimal.exact x) in
  exact "eighth" (Some "0.125") (q 1 8);
  exact "third" None (q 1 3);
  exact "tiny" None tiny

let suite =
  let case name test = Alcotest.test_case name `Quick test in
  ("where",
   [
     ( "sets",
       [
         case "by hand" by_hand; case "no parameters" without_parameters; case "unknown" unknown;
         case "refused" refused;
       ] );
     ("laws", Scc_test_support.Property.cases [ parts; same_sets; no_two_convex; measures; ordered ]);
     ("decimals", [ case "decimals" decimals ]);
   ])
