(* Bernstein coefficients against polynomials and algebraic numbers by Sturm's theorem. *)

open Scc_exact
module Gen = QCheck2.Gen

let ratio p q = Rat.make (Z.of_int p) (Z.of_int q)
let poly l = Polynomial.of_coefficients (List.map Rat.of_int l)
let rational = Gen.map2 ratio Gen.(-12 -- 12) Gen.(1 -- 6)

(* Products of a few factors with repeated ones, so that roots are multiple, shared, rational and irrational. *)
let factors =
  List.map poly
    [ [ 0; 1 ]; [ -1; 1 ]; [ -1; 2 ]; [ 1; 3 ]; [ -2; 0; 1 ]; [ -1; 1; 1 ]; [ 1; 0; 1 ]; [ -1; -1; 0; 1 ];
      [ 1; -3; 1 ] ]

let product =
  let power = Gen.(pair (oneofl factors) (1 -- 3)) in
  let rec multiply = function
    | [] -> Polynomial.one
    | (_, 0) :: rest -> multiply rest
    | (f, n) :: rest -> Polynomial.mul f (multiply ((f, n - 1) :: rest))
  in
  Gen.map2 (fun c l -> Polynomial.scale c (multiply l)) rational Gen.(list_size (0 -- 3) power)

let scattered = Gen.map poly Gen.(list_size (0 -- 6) (-9 -- 9))
let polynomial = Gen.frequency [ (3, product); (2, scattered) ]
let interval = Gen.map2 (fun a w -> (a, Rat.add a (Rat.abs w))) rational rational
let proper (low, high) = Rat.compare low high < 0
let algebraic r = Bernstein.to_algebraic r ~scale:Rat.one ~shift:Rat.zero
let show_root = function Some r -> Algebraic.to_string r | None -> "never"

(* All roots, by Sturm. *)
let sturm_roots p (low, high) = Algebraic.roots p ~low ~high:(Some high)

let same_roots =
  let print (p, (low, high)) =
    Printf.sprintf "%s in (%s, %s)" (Polynomial.to_string p) (Rat.to_string low)
      (Rat.to_string high) in QCheck2.Test.make ~name:"roots" ~count:1000 ~print Gen.(pair polynomial interval)
    (fun (p, (low, high)) -> QCheck2.assume (not (Polynomial.is_zero p));
      let found = List.map algebraic (Bernstein.roots p ~low ~high) in
      let expected = if proper (low, high) then sturm_roots p (low, high) else [] in
      List.length found = List.length expected && List.for_all2 Algebraic.equal found expected)

(* The first instant from [after] on, right after which p is negative: after itself or one of the roots. *)
let negative_first p after until =
  let roots =
    if Polynomial.is_zero p then []
    else
      let low = Rat.sub (fst (Algebraic.enclose after ~width:Rat.one)) Rat.one in
      List.filter (fun r -> Algebraic.compare r after > 0) (sturm_roots p (low, until))
  in
  let rec scan start rest =
    let next = match rest with [] -> Algebraic.of_rat until | r :: _ -> r in
    if Polynomial.sign_at p (Algebraic.between start next) < 0 then Some start
    else match rest with [] -> None | r :: rest -> scan r rest
  in
  if Algebraic.compare_rat after until >= 0 then None else scan after roots

let first_of p after until =
  match Bernstein.first_negative p ~after ~until with
  | Nowhere -> None
  | At_once -> Some (algebraic after)
  | Later r ->
    if Bernstein.compare after r >= 0 then failwith "not later";
    if Rat.compare (Bernstein.high r) until > 0 then failwith "beyond the end";
    Some (algebraic r)

let agrees p after until =
  let found = first_of p after until and expected = negative_first p (algebraic after) until in
  Option.equal Algebraic.equal found expected
  || QCheck2.Test.fail_reportf "%s from %s to %s: %s instead of %s" (Polynomial.to_string p)
    (Algebraic.to_string (algebraic after)) (Rat.to_string until) (show_root found) (show_root expected)

let from_rational =
  QCheck2.Test.make ~name:"first negative after a rational" ~count:1000 Gen.(pair polynomial interval)
    (fun (p, (low, high)) -> agrees p (Bernstein.rational low) high)

(* The start is a root, often one of the polynomial too. *)
let from_root =
  QCheck2.Test.make ~name:"first negative after a root" ~count:1000 Gen.(triple polynomial polynomial interval)
    (fun (p, q, (low, high)) ->
       QCheck2.assume (not (Polynomial.is_zero q));
       List.for_all
         (fun after -> agrees p after high && agrees (Polynomial.mul p q) after high && agrees q after high)
         (Bernstein.roots q ~low ~high))

let comparison =
  QCheck2.Test.make ~name:"comparison" ~count:500 Gen.(triple polynomial polynomial interval)
    (fun (p, q, (low, high)) ->
       QCheck2.assume (not (Polynomial.is_zero p || Polynomial.is_zero q));
       let all = Bernstein.roots p ~low ~high @ Bernstein.roots (Polynomial.mul p q) ~low ~high in
       let sign x = Int.compare x 0 in
       List.for_all
         (fun x ->
            List.for_all
              (fun y -> sign (Bernstein.compare x y) = sign (Algebraic.compare (algebraic x) (algebraic y)))
              all)
         all)

let halves =
  QCheck2.Test.make ~name:"halves" ~count:500 Gen.(pair polynomial interval) (fun (p, (low, high)) ->
      QCheck2.assume (proper (low, high));
      let whole = Bernstein.make p ~low ~high in
      let l, r = Bernstein.halve whole in
      let last (b : Bernstein.t) = b.coefficients.(Array.length b.coefficients - 1) in
      let same (b : Bernstein.t) =
        (* in proportion to a fresh conversion *)
        let fresh = Bernstein.make p ~low:b.low ~high:b.high in
        let n = Array.length b.coefficients - 1 in
        List.for_all
          (fun i ->
             Z.equal
               (Z.mul b.coefficients.(i) (Z.abs fresh.coefficients.(0)))
               (Z.mul fresh.coefficients.(i) (Z.abs b.coefficients.(0))))
          (List.init (n + 1) Fun.id)
      in
      same l && same r
      && Bernstein.variations l + Bernstein.variations r <= Bernstein.variations whole
      && Z.sign l.coefficients.(0) = Polynomial.sign_at p low
      && Z.sign (last r) = Polynomial.sign_at p high
      && Z.sign (last l) = Polynomial.sign_at p l.high)

let narrowed =
  QCheck2.Test.make ~name:"narrowing and moving" ~count:100 Gen.(triple polynomial interval rational)
    (fun (p, (low, high), shift) ->
       QCheck2.assume (not (Polynomial.is_zero p));
       let width = ratio 1 1000 and scale = ratio 3 7 in
       List.for_all
         (fun r ->
            let n = Bernstein.narrow r ~width in
            let moved = Bernstein.to_algebraic n ~scale ~shift in
            let expected = Polynomial.substitute p ~scale:(ratio 7 3) ~shift:(Rat.mul (ratio (-7) 3) shift) in
            Rat.compare (Rat.sub (Bernstein.high n) (Bernstein.low n)) width <= 0
            && Bernstein.compare n r = 0
            && Algebraic.sign_at expected moved = 0
            && Algebraic.compare_rat moved (Rat.add shift (Rat.mul scale (Bernstein.low n))) >= 0
            && Algebraic.compare_rat moved (Rat.add shift (Rat.mul scale (Bernstein.high n))) <= 0)
         (Bernstein.roots p ~low ~high))

let odd_parts =
  QCheck2.Test.make ~name:"odd part" ~count:500 ~print:Polynomial.to_string product (fun p ->
      let odd = Polynomial.odd_part p in
      let at x = Polynomial.sign_at p x = 0 || Polynomial.sign_at p x = Polynomial.sign_at odd x in
      List.for_all (fun i -> at (ratio i 7)) (List.init 60 (fun i -> i - 30))
      && Polynomial.degree (Polynomial.square_free odd) = Polynomial.degree odd)

(* A polynomial of degree 5 with one rational root: the others are irrational although no prime shows it. *)
let mixed () =
  let p = Polynomial.mul (poly [ -2; 3 ]) (Polynomial.mul (poly [ -2; 0; 1 ]) (poly [ -3; 0; 1 ])) in
  let found = Bernstein.roots p ~low:Rat.zero ~high:(Rat.of_int 4) in
  let expected = sturm_roots p (Rat.zero, Rat.of_int 4) in
  let same = List.for_all2 Algebraic.equal (List.map algebraic found) expected in
  Alcotest.(check bool) "the same" true same;
  let is_rational r = Option.is_some (Algebraic.to_rat (algebraic r)) in
  Alcotest.(check (list bool)) "rational" [ true; false; false ] (List.map is_rational found)

let suite =
  ("Bernstein coefficients",
   [ ( "against Sturm",
       Scc_test_support.Property.cases
         [ halves; same_roots; from_rational; from_root; comparison; narrowed; odd_parts ]
       @ [ Alcotest.test_case "rational and irrational roots" `Quick mixed ] ) ])
