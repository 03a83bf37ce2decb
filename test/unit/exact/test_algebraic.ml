(* Polynomials and real algebraic numbers, against what is known of products of small factors. *)

open Scc_exact
module Gen = QCheck2.Gen

let int = Rat.of_int
let rational n d = Rat.make (Z.of_int n) (Z.of_int d)
let polynomial l = Polynomial.of_coefficients (List.map int l)

(** {2 Products of factors} *)

(* Each factor with its real roots: d t - n, or a t^2 + b t + c. *)
type factor = Linear of int * int | Quadratic of int * int * int

let of_factor = function
  | Linear (n, d) -> polynomial [ -n; d ]
  | Quadratic (a, b, c) -> polynomial [ c; b; a ]

let factor_gen =
  let open Gen in
  let small = int_range (-4) 4 in
  oneof
    [
      map2 (fun n d -> Linear (n, d)) small (int_range 1 4);
      map3 (fun a b c -> Quadratic (a, b, c)) (int_range 1 3) small small;
    ]

let print_factor f = "(" ^ Polynomial.to_string (of_factor f) ^ ")"
let print_factors l = String.concat "" (List.map print_factor l)
let factors_gen = Gen.list_size (Gen.int_range 1 5) factor_gen
let product l = List.fold_left (fun p f -> Polynomial.mul p (of_factor f)) Polynomial.one l

(* The real roots of one factor as floats, lowest first: for small integers these are far more exact than
   distinct roots are close. *)
let float_roots = function
  | Linear (n, d) -> [ float_of_int n /. float_of_int d ]
  | Quadratic (a, b, c) ->
    let a = float_of_int a and b = float_of_int b and c = float_of_int c in
    let d = (b *. b) -. (4. *. a *. c) in
    if d < 0. then []
    else if d = 0. then [ -.b /. (2. *. a) ]
    else [ (-.b -. sqrt d) /. (2. *. a); (-.b +. sqrt d) /. (2. *. a) ]

let distinct l =
  List.sort Float.compare l
  |> List.fold_left
    (fun acc x -> match acc with y :: _ when Float.abs (x -. y) < 1e-9 -> acc | _ -> x :: acc)
    []
  |> List.rev

let to_float a =
  let low, high = Algebraic.enclose a ~width:(rational 1 1_000_000_000_000) in
  Rat.to_float (Rat.div (Rat.add low high) (int 2))

let all_roots p = Algebraic.roots p ~low:(int (-100)) ~high:None

let roots_are_found =
  QCheck2.Test.make ~count:3000 ~name:"the roots of a product are those of its factors" ~print:print_factors
    factors_gen (fun factors ->
        let expected = distinct (List.concat_map float_roots factors) in
        let found = all_roots (product factors) in
        List.length expected = List.length found
        && List.for_all2 (fun e a -> Float.abs (e -. to_float a) < 1e-9) expected found)

let rational_roots_are_rational =
  QCheck2.Test.make ~count:1000 ~name:"a rational root is found as a rational" ~print:print_factors
    factors_gen (fun factors ->
        let found = all_roots (product factors) in
        List.for_all
          (function
            | Linear (n, d) ->
              List.exists
                (fun a ->
                   match Algebraic.to_rat a with Some r -> Rat.equal r (rational n d) | None -> false)
                found
            | Quadratic _ -> true)
          factors)

let signs_at_roots =
  QCheck2.Test.make ~count:2000 ~name:"signs at roots are exact"
    ~print:(fun (a, b) -> print_factors a ^ " at the roots of " ^ print_factors b)
    (Gen.pair factors_gen factors_gen)
    (fun (a, b) ->
       let p = product a in
       let zero_or_float r =
         let s = Algebraic.sign_at p r in
         let zero = List.exists (fun e -> Float.abs (e -. to_float r) < 1e-9) (List.concat_map float_roots a) in
         if zero then s = 0
         else
           let x = to_float r in
           let value =
             List.fold_right
               (fun c acc -> Rat.to_float c +. (x *. acc))
               (Polynomial.coefficients p) 0.
           in
           s = compare value 0.
       in
       List.for_all zero_or_float (all_roots (product b)))

let order =
  QCheck2.Test.make ~count:1000 ~name:"numbers are ordered as they should, whatever polynomial they come from"
    ~print:(fun (a, b) -> print_factors a ^ " and " ^ print_factors b)
    (Gen.pair factors_gen factors_gen)
    (fun (a, b) ->
       let left = all_roots (product a) and right = all_roots (product b) in
       List.for_all
         (fun x ->
            List.for_all
              (fun y ->
                 let c = Algebraic.compare x y in
                 let d = to_float x -. to_float y in
                 c = - (Algebraic.compare y x)
                 && (if Float.abs d < 1e-9 then c = 0 else c = compare d 0.)
                 && (c >= 0
                     ||
                     let m = Algebraic.between x y in
                     Algebraic.compare_rat x m < 0 && Algebraic.compare_rat y m > 0)
                 &&
                 let moved = Algebraic.add_rat (rational 1 3) in
                 Algebraic.compare (moved x) (moved y) = c)
              right)
         left)

let range =
  QCheck2.Test.make ~count:1000 ~name:"only the roots strictly inside the interval are listed"
    ~print:(fun (f, a, b) -> Printf.sprintf "%s in (%d/2, %d/2)" (print_factors f) a b)
    (Gen.triple factors_gen (Gen.int_range (-8) 8) (Gen.int_range (-8) 8))
    (fun (factors, a, b) ->
       let low = rational a 2 and high = rational b 2 in
       let p = product factors in
       let inside r = Algebraic.compare_rat r low > 0 && Algebraic.compare_rat r high < 0 in
       let expected = List.filter inside (all_roots p) in
       let found = Algebraic.roots p ~low ~high:(Some high) in
       List.length expected = List.length found && List.for_all2 Algebraic.equal expected found)

let division =
  QCheck2.Test.make ~count:1000 ~name:"division with remainder"
    ~print:(fun (a, b) -> print_factors a ^ " by " ^ print_factors b)
    (Gen.pair factors_gen factors_gen)
    (fun (a, b) ->
       let a = Polynomial.add (product a) Polynomial.variable and b = product b in
       let q, r = Polynomial.divide a b in
       Polynomial.degree r < Polynomial.degree b
       && Polynomial.equal a (Polynomial.add (Polynomial.mul q b) r))

(** {2 Particular numbers} *)

let texts () =
  let show p = List.map Algebraic.to_string (Algebraic.roots p ~low:Rat.zero ~high:None) in
  let check what expected p = Alcotest.(check (list string)) what expected (show p) in
  check "irrational" [ "root of 2t^2 - 3 in (6/5, 13/10), about 1.224745" ] (polynomial [ -3; 0; 2 ]);
  check "rational" [ "3/2" ] (polynomial [ -9; 0; 4 ]);
  check "cubic" [ "root of t^3 - t - 1 in (13/10, 7/5), about 1.324718" ] (polynomial [ -1; -1; 0; 1 ]);
  check "close to a rational"
    [ "root of 10000t^2 - 20001 in (7/5, 3/2), about 1.414249" ]
    (polynomial [ -20001; 0; 10000 ]);
  check "two close ones"
    [ "1/2"; "5001/10000" ]
    (Polynomial.mul (polynomial [ -1; 2 ]) (polynomial [ -5001; 10000 ]))

(* Wilkinson's polynomial, moved off the integers by a little: hopeless in floating point. *)
let wilkinson () =
  let p =
    List.fold_left
      (fun p i -> Polynomial.mul p (polynomial [ -i; 1 ]))
      Polynomial.one
      (List.init 20 (fun i -> i + 1))
  in
  let roots = Algebraic.roots p ~low:Rat.zero ~high:None in
  Alcotest.(check (list string)) "roots"
    (List.init 20 (fun i -> string_of_int (i + 1)))
    (List.map Algebraic.to_string roots);
  let moved = Polynomial.sub p (Polynomial.constant (rational 1 1024)) in
  Alcotest.(check int) "moved" 20 (List.length (Algebraic.roots moved ~low:Rat.zero ~high:None))

(* The decimal nearest to a root of whole numbers, by roots of whole numbers; also where it is close to a tie. *)
let nearest_decimals =
  QCheck2.Test.make ~name:"decimals of roots are the nearest" ~count:300
    ~print:QCheck2.Print.(pair Z.to_string int)
    Gen.(pair (map (fun (n, odd) -> if odd then Z.succ (Z.mul (Z.of_int n) (Z.of_int n)) else Z.of_int n)
                 (pair (int_range 1 1_000_000) bool)) (int_bound 9))
    (fun (n, digits) ->
       let p = Polynomial.of_coefficients [ Q.of_bigint (Z.neg n); Rat.zero; Rat.one ] in
       let root = List.hd (Algebraic.roots p ~low:Rat.zero ~high:None) in
       let whole = Z.sqrt (Z.mul n (Z.pow (Z.of_int 10) (2 * digits))) in
       let half = Z.add (Z.shift_left whole 1) Z.one in
       let is_above = Z.leq (Z.mul half half) (Z.mul (Z.of_int 4) (Z.mul n (Z.pow (Z.of_int 10) (2 * digits)))) in
       let nearest = Rat.make (if is_above then Z.succ whole else whole) (Z.pow (Z.of_int 10) digits) in
       String.equal (Algebraic.to_decimal ~digits root) (Decimal.padded ~places:digits nearest))

(* Mignotte's polynomials have two roots extremely close together. *)
let mignotte () =
  let square = Polynomial.mul (polynomial [ -1; 100 ]) (polynomial [ -1; 100 ]) in
  let tenth = polynomial (List.init 11 (fun i -> if i = 10 then 1 else 0)) in
  let p = Polynomial.sub tenth (Polynomial.scale (int 2) square) in
  match Algebraic.roots p ~low:Rat.zero ~high:(Some Rat.one) with
  | [ a; b ] ->
    Alcotest.(check bool) "ordered" true (Algebraic.compare a b < 0);
    Alcotest.(check int) "1/100 between" 1 (Algebraic.compare_rat b (rational 1 100));
    Alcotest.(check int) "1/100 between" (-1) (Algebraic.compare_rat a (rational 1 100))
  | l -> Alcotest.failf "%d roots" (List.length l)

let () =
  let quick name f = Alcotest.test_case name `Quick f in
  Alcotest.run "algebraic"
    [
      ( "random",
        Scc_test_support.Property.cases
          [ roots_are_found; rational_roots_are_rational; signs_at_roots; order; range; division;
            nearest_decimals ] );
      ( "cases",
        [
          quick "texts" texts;
          quick "Wilkinson's polynomial" wilkinson;
          quick "Mignotte's polynomial" mignotte;
        ] );
    ]
