(* Sets of parameters in words, as JSON and as a script of SMT-LIB. *)
open Scc_polyhedra
open Scc_regions
open Where_samples.Samples

let check_lines name expected w = Alcotest.(check (list string)) name expected (Words.lines w)
let x04 = [| whole "x" 0 4 |]
let upto a = set 1 [ [ not_positive 1 (-a) [ 1 ] ] ]
let above a = set 1 [ [ negative 1 a [ -1 ] ] ]
let at_point a = set 1 [ [ is_zero 1 (-a) [ 1 ] ] ]

let reports () =
  check_lines "two cubes"
    [ "holds where"; "  -2 < y < 2, -2 < z < 2"; "fails elsewhere"; "probability 4/25 = 0.16" ]
    cubes;
  check_lines "octahedron"
    [
      "holds where"; "  -2 < y < 2, -2 < z < 2, -3 < y + z < 3, -3 < y - z < 3"; "fails elsewhere";
      "probability 7/18, about 0.3889";
    ]
    octahedron;
  check_lines "ligands"
    [ "holds where"; "  2s + 2 <= t"; "fails elsewhere"; "probability 1/9, about 0.1111" ]
    possibly;
  check_lines "everywhere" [ "holds everywhere"; "probability 1" ] (of_test x04 true);
  check_lines "nowhere" [ "fails everywhere"; "probability 0" ] (of_test x04 false);
  check_lines "no parameters" [ "holds everywhere"; "probability 1" ] (of_test [||] true);
  check_lines "the shorter side"
    [ "fails where"; "  1 < x <= 2"; "holds elsewhere"; "probability 3/4 = 0.75" ]
    (decided x04 ~holds:(Union.union (upto 1) (above 2)))

let without_volume () =
  check_lines "a tie"
    [ "holds where"; "  2s + 2 = t (no area)"; "fails elsewhere"; "probability 0, but not nowhere" ]
    tie;
  check_lines "all but a point"
    [ "fails where"; "  x = 1 (no length)"; "holds elsewhere"; "probability 1, but not everywhere" ]
    (decided x04 ~holds:(Union.difference (Union.universe 1) (at_point 1)));
  check_lines "two pieces"
    [ "holds where"; "  x <= 1"; "  or x = 2 (no length)"; "fails elsewhere"; "probability 1/4 = 0.25" ]
    (decided x04 ~holds:(Union.union (upto 1) (at_point 2)))

let unknown () =
  check_lines "a part"
    [
      "holds where"; "  x <= 1"; "fails where"; "  x > 2"; "not known elsewhere";
      "probability at least 1/4 = 0.25, and at most 1/2 = 0.5";
    ]
    (Where.make x04 ~holds:(upto 1) ~fails:(above 2));
  check_lines "all" [ "not known anywhere"; "probability at least 0, and at most 1" ]
    (Where.make x04 ~holds:(Union.empty 1) ~fails:(Union.empty 1));
  check_lines "may fail"
    [
      "holds where"; "  x <= 1"; "not known to fail anywhere"; "not known elsewhere";
      "probability at least 1/4 = 0.25, and at most 1";
    ]
    (Where.make x04 ~holds:(upto 1) ~fails:(Union.empty 1));
  check_lines "all but a point"
    [
      "holds where"; "  x < 1"; "  or x > 1"; "not known to fail anywhere"; "not known elsewhere";
      "probability 1, but not known everywhere";
    ]
    (Where.make x04 ~holds:(Union.difference (Union.universe 1) (at_point 1)) ~fails:(Union.empty 1));
  check_lines "but for a point"
    [ "not known to hold anywhere"; "fails where"; "  x < 1"; "  or x > 1"; "not known elsewhere";
      "probability 0" ]
    (Where.make x04 ~holds:(Union.empty 1) ~fails:(Union.difference (Union.universe 1) (at_point 1)))

let numbers () =
  let check expected x = Alcotest.(check string) expected expected (Words.number x) in
  check "3" (q 3 1);
  check "1/8 = 0.125" (q 1 8);
  check "1/3, about 0.3333" (q 1 3);
  check "99999/100001, more than 0.9999" (q 99999 100001);
  check "100001/99999, about 1" (q 100001 99999)

let open_ranges () =
  let ranges = [| range ~low:false "x" (q 0 1) (q 1 2) |] in
  let piece constraints = Words.piece ranges (Polyhedron.of_constraints 1 constraints) in
  let check name expected found = Alcotest.(check string) name expected found in
  check "all" "everywhere" (piece []);
  check "the range is left out" "x < 1/3" (piece [ negative 1 (-1) [ 3 ]; negative 1 0 [ -1 ] ]);
  check "a border that the range has not" "x < 1/2" (piece [ negative 1 (-1) [ 2 ] ])

(* {1 JSON} *)

let json () =
  let check name expected w =
    Alcotest.(check string) name expected (Scc_json.Json.line (Scc_reports.Where_json.where w))
  in
  let c coefficients relation bound =
    Printf.sprintf "{\"coefficients\":{%s},\"relation\":\"%s\",\"bound\":\"%s\"}" coefficients relation bound
  in
  let x a = Printf.sprintf "\"x\":\"%s/1\"" a in
  check "a part is unknown"
    ({|{"parameters":["x"],"pieces":[[|} ^ c (x "-1") "<=" "0/1" ^ "," ^ c (x "1") "<=" "1/1"
     ^ {|]],"measure":"1/1","probability":null,"probability_between":["1/4","1/2"],"range":[|}
     ^ c (x "-1") "<=" "0/1" ^ "," ^ c (x "1") "<=" "4/1" ^ {|],"fails":{"pieces":[[|}
     ^ c (x "-1") "<" "-2/1" ^ ","
     ^ c (x "1") "<=" "4/1" ^ {|]],"measure":"2/1"},"unknown":{"pieces":[[|} ^ c (x "-1") "<" "-1/1" ^ ","
     ^ c (x "1") "<=" "2/1" ^ {|]],"measure":"1/1"}}|})
    (Where.make x04 ~holds:(upto 1) ~fails:(above 2));
  check "a tie"
    ({|{"parameters":["x"],"pieces":[[|} ^ c (x "1") "=" "1/1"
     ^ {|]],"measure":"0/1","probability":"0/1","range":[|} ^ c (x "-1") "<=" "0/1" ^ "," ^ c (x "1") "<=" "4/1"
     ^ {|],"fails":{"pieces":[[|} ^ c (x "-1") "<=" "0/1" ^ "," ^ c (x "1") "<" "1/1" ^ "],["
     ^ c (x "-1") "<" "-1/1" ^ ","
     ^ c (x "1") "<=" "4/1" ^ {|]],"measure":"4/1"},"unknown":{"pieces":[],"measure":"0/1"}}|})
    (decided x04 ~holds:(at_point 1));
  let plane = Scc_reports.Where_json.where
      (decided ligands ~holds:(set 2 [ [ is_zero 2 (-1) [ 1; 0 ] ] ])) in
  let pieces = Option.get (Scc_json.Json.member "pieces" plane) in
  let t a = Printf.sprintf "\"t\":\"%s/1\"" a in
  Alcotest.(check string) "without coefficients that are 0"
    ("[[" ^ c "\"s\":\"1/1\"" "=" "1/1" ^ "," ^ c (t "-1") "<=" "0/1" ^ "," ^ c (t "1") "<=" "6/1" ^ "]]")
    (Scc_json.Json.line pieces);
  check "no parameters"
    ({|{"parameters":[],"pieces":[[]],"measure":"1/1","probability":"1/1","range":[],|}
     ^ {|"fails":{"pieces":[],"measure":"0/1"},"unknown":{"pieces":[],"measure":"0/1"}}|})
    (of_test [||] true)

(* {1 SMT-LIB} *)

let smt () =
  let ranges = [| whole "abs" 0 4 |] in
  let form = Linear.of_terms 1 ~constant:Scc_exact.Rat.one [ (0, Scc_exact.Rat.make Z.one (Z.of_int 2)) ] in
  let number = Chances.make ranges [ (Scc_calculus.Ranges.box ranges, { least = Some form; most = None }) ] in
  let script = Smt.script ranges ~numbers:[ ("mean", number) ] [ ("meets", decided ranges ~holds:(upto 1)) ] in
  Alcotest.(check string) "script"
    ({|(set-info :smt-lib-version 2.6)
(set-logic QF_LRA)
(declare-const param-abs Real)
(assert (and (<= (* (- 1.0) param-abs) 0.0) (<= param-abs 4.0)))
(define-fun meets-holds () Bool (and (<= (* (- 1.0) param-abs) 0.0) (<= param-abs 1.0)))
(define-fun meets-fails () Bool (and (< (* (- 1.0) param-abs) (- 1.0)) (<= param-abs 4.0)))
(define-fun meets-unknown () Bool false)
(define-fun mean-low () Real (ite (and (<= (* (- 1.0) param-abs) 0.0) (<= param-abs 4.0)) |}
     ^ {|(+ (* (/ 1.0 2.0) param-abs) 1.0) 0.0))
(define-fun mean-low-infinite () Bool false)
(define-fun mean-high () Real 0.0)
(define-fun mean-high-infinite () Bool (and (<= (* (- 1.0) param-abs) 0.0) (<= param-abs 4.0)))
(define-fun mean-unknown () Bool false)
|})
    script

let suite =
  let case name test = Alcotest.test_case name `Quick test in
  ("words",
   [
     ( "words",
       [
         case "reports" reports; case "without volume" without_volume; case "unknown" unknown;
         case "numbers" numbers;
         case "open ranges" open_ranges;
       ] );
     ("json", [ case "json" json ]);
     ("smt", [ case "smt" smt ]);
   ])
