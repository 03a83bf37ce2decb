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

let () =
  Alcotest.run "numbers"
    [
      ( "floats",
        Scc_test_support.Property.cases [ next_float ] @ [ Alcotest.test_case "special ones" `Quick special ] );
      ("rationals", Scc_test_support.Property.cases [ order ]);
    ]
