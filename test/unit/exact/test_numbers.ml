(* What is faster than the library's own: against the library's own. *)

open Scc_exact
module Gen = QCheck2.Gen

let same_bits a b = Int64.equal (Int64.bits_of_float a) (Int64.bits_of_float b)

let agrees x =
  same_bits (Next_float.succ x) (Float.succ x) && same_bits (Next_float.pred x) (Float.pred x)

let any_float = Gen.map Int64.float_of_bits Gen.int64

(* Two that are no number may differ in bits that mean nothing. *)
let next_float =
  QCheck2.Test.make ~count:100_000 ~name:"the next floats of any" ~print:(Printf.sprintf "%h") any_float (fun x ->
      Float.is_nan x || agrees x)

let special () =
  List.iter
    (fun x -> Alcotest.(check bool) (Printf.sprintf "%h" x) true (agrees x && agrees (-.x)))
    [ 0.; 0x1p-1074; 0x0.fffffffffffffp-1022; 0x1p-1022; 1.; Float.max_float; infinity ];
  Alcotest.(check bool) "no number" true (Float.is_nan (Next_float.succ nan) && Float.is_nan (Next_float.pred nan))

(* Two of any size, two that are near each other, and such as have a sum that is a float. *)
let two_floats =
  let open Gen in
  let finite = map (fun x -> if Float.is_nan x then 1. else x) any_float in
  let small = map2 (fun k n -> Float.ldexp (float_of_int n) k) (int_range (-80) 80) (int_range (-99) 99) in
  let scaled = map3 (fun x k y -> (x, x *. Float.ldexp y k)) finite (int_range (-60) 2) (float_range (-2.) 2.) in
  let simple = map (fun n -> float_of_int n /. 8.) (int_range (-99) 99) in
  oneof [ pair finite finite; pair finite small; scaled; pair simple simple ]

(* Bounds that are no farther than the next floats; and the sum itself, where it is a float. *)
let sums =
  QCheck2.Test.make ~count:200_000 ~name:"sums rounded down and up"
    ~print:(fun (a, b) -> Printf.sprintf "%h + %h" a b)
    two_floats
    (fun (a, b) ->
       let below = Next_float.sum_below a b and above = Next_float.sum_above a b and near = a +. b in
       if Float.is_nan near || Float.abs a = infinity || Float.abs b = infinity then true
       else
         let exact = Q.add (Q.of_float a) (Q.of_float b) in
         let at_most x y = x = neg_infinity || (x < infinity && Q.compare (Q.of_float x) y <= 0) in
         let at_least x y = x = infinity || (x > neg_infinity && Q.compare (Q.of_float x) y >= 0) in
         at_most below exact && at_least above exact
         && below >= Float.pred near && above <= Float.succ near
         &&
         let is_exact = Float.abs near < infinity && Q.equal (Q.of_float near) exact in
         (not is_exact) || (below = near && above = near))

let infinite_sums () =
  let check what expected found = Alcotest.(check (float 0.)) what expected found in
  check "down from infinity" max_float (Next_float.sum_below infinity 1.);
  check "minus infinity" neg_infinity (Next_float.sum_below neg_infinity 1.);
  check "up from minus infinity" (-.max_float) (Next_float.sum_above neg_infinity 1.);
  check "infinity" infinity (Next_float.sum_above 1. infinity);
  check "what is too great" max_float (Next_float.sum_below max_float max_float)

(* Small ones, whose denominators are often the same, and some of many digits. *)
let rational =
  let open Gen in
  let small = map2 Rat.make (map Z.of_int (int_range (-20) 20)) (map Z.of_int (int_range 1 6)) in
  let long a k = Z.succ (Z.shift_left (Z.of_int a) k) in
  let large =
    map3 (fun a b k -> Rat.make (long a k) (long b k)) (int_range (-3) 3) (int_range 1 3) (int_range 50 130)
  in
  frequency [ (3, small); (1, large) ]

let order =
  QCheck2.Test.make ~count:100_000 ~name:"the order of rationals"
    ~print:(fun (a, b) -> Rat.to_string a ^ " " ^ Rat.to_string b)
    Gen.(pair rational rational)
    (fun (a, b) ->
       let sign = Int.compare (Q.compare a b) 0 in
       Int.compare (Rat.compare a b) 0 = sign
       && Q.equal (Rat.min a b) (Q.min a b)
       && Q.equal (Rat.max a b) (Q.max a b)
       && Int.compare (Rat.sign (Rat.sub a b)) 0 = sign)

let is_float =
  QCheck2.Test.make ~count:100_000 ~name:"those that are floats" ~print:Rat.to_string
    Gen.(
      let scaled q k = Rat.mul q (Q.of_float (Float.ldexp 1. k)) in
      oneof [ rational; map2 scaled rational (int_range (-70) 70) ])
    (fun q -> (not (Rat.is_float q)) || Q.equal (Q.of_float (Rat.to_float q)) q)

let which_are_floats () =
  let check expected q = Alcotest.(check bool) (Rat.to_string q) expected (Rat.is_float q) in
  let numbers = List.map Q.of_string in
  List.iter (check true) (numbers [ "0"; "1"; "-7/8"; "9007199254740992"; "3/2305843009213693952" ]);
  List.iter (check false) (numbers [ "1/3"; "9007199254740993"; "-9007199254740993/2" ])

(* The limit is on digits: a point is none, and zeros before an exponent change nothing. *)
let literals () =
  let digits = String.make Rat.max_digits '7' in
  let pointed = "7." ^ String.make (Rat.max_digits - 1) '7' in
  let reads text = Alcotest.(check bool) text true (Result.is_ok (Rat.of_literal text)) in
  let is_too_large text = Alcotest.(check bool) text true (Rat.of_literal text = Error Rat.Too_large) in
  List.iter reads [ digits; pointed; digits ^ "/" ^ pointed; "-" ^ pointed ];
  List.iter is_too_large [ "7" ^ digits; pointed ^ "7"; digits ^ "e1"; "1e4000"; "1e1000000000" ];
  let equal text expected =
    Alcotest.(check string) text expected
      (match Rat.of_literal text with Ok q -> Rat.to_string q | Error _ -> "refused")
  in
  List.iter (fun (text, expected) -> equal text expected)
    [ ("6", "6"); ("-1/4", "-1/4"); ("0.125", "1/8"); ("1e-3", "1/1000"); ("", "refused"); ("x", "refused") ];
  Alcotest.(check bool) "1/0" true (Rat.of_literal "1/0" = Error Rat.Zero_denominator);
  equal "1e0000000001" "10";
  equal "1e-0000000000001" "1/10";
  equal "5e+000000000000" "5";
  equal ("1e" ^ String.make 5000 '0' ^ "2") "100"

(* With zeros among the numbers, and longer ones. *)
let axpy =
  let quotient n d = Rat.make (Z.of_int n) (Z.of_int d) in
  let rational = Gen.map2 quotient (Gen.int_range (-3) 3) (Gen.int_range 1 3) in
  let vector = Gen.map3 Vec.make rational rational rational in
  QCheck2.Test.make ~count:5_000 ~name:"a x + y"
    ~print:(fun (k, x, y) -> String.concat " " [ Rat.to_string k; Vec.to_string x; Vec.to_string y ])
    (Gen.triple rational vector vector)
    (fun (k, x, y) -> Vec.equal (Vec.axpy k x y) (Vec.add (Vec.scale k x) y))

let () =
  Alcotest.run "numbers"
    [
      ( "floats",
        Scc_test_support.Property.cases [ next_float; sums ]
        @ [
          Alcotest.test_case "special ones" `Quick special;
          Alcotest.test_case "infinite sums" `Quick infinite_sums;
        ] );
      ( "rationals",
        Scc_test_support.Property.cases [ order; is_float ]
        @ [ Alcotest.test_case "which are floats" `Quick which_are_floats ] );
      ("vectors", Scc_test_support.Property.cases [ axpy ]);
      ("literals", [ Alcotest.test_case "how many digits" `Quick literals ]);
    ]
