(* Rule Lot: the chance of what happens at a rate, within a step. *)

open Scc_exact
open Scc_calculus
module Gen = QCheck2.Gen

let q n d = Rat.make (Z.of_int n) (Z.of_int d)
let power k = Q.of_bigint (Z.shift_left Z.one k)

(* exp(x) for x > 0, from below and from above: by n terms of its series, whose rest is less than twice the next
   term where n > 2x. A computation of its own, and exact. *)
let exponential x =
  let rec sum n term total =
    let term = Rat.div (Rat.mul term x) (Rat.of_int n) in
    let small = Rat.compare (Rat.mul term (power 80)) total < 0 in
    if small && Rat.compare (Rat.of_int n) (Rat.mul (Rat.of_int 2) x) > 0 then
      (total, Rat.add total (Rat.mul (Rat.of_int 2) term))
    else sum (n + 1) term (Rat.add total term)
  in
  sum 1 Rat.one Rat.one

(* 1 - exp(-x) = 1 - 1/exp(x), between two numbers. *)
let value x =
  let low, high = exponential x in
  let one_minus_inverse e = Rat.sub Rat.one (Rat.div Rat.one e) in
  (one_minus_inverse low, one_minus_inverse high)

let tolerance (v, _) = Rat.div (Rat.min v (Rat.sub Rat.one v)) (power 40)

let is_near ((low, high) as v) p =
  let slack = tolerance v in
  Rat.compare (Rat.sub low slack) p < 0 && Rat.compare p (Rat.add high slack) < 0

let near =
  let gen = Gen.(pair (map2 q (1 -- 60) (1 -- 40)) (map2 q (1 -- 20) (1 -- 30))) in
  let print (r, h) = Printf.sprintf "rate %s, step %s" (Rat.to_string r) (Rat.to_string h) in
  QCheck2.Test.make ~name:"Lot: chances of rates" ~count:50 ~print gen (fun (rate, step) ->
      let p = Odds.within ~step rate in
      is_near (value (Rat.mul rate step)) p && Rat.sign p > 0 && Rat.compare p Rat.one < 0)

(* No fraction of a smaller denominator is as near: looked for by brute force where denominators are small. *)
let simplest () =
  List.iter
    (fun x ->
       let p = Odds.within ~step:Rat.one x and v = value x in
       for d = 1 to min 3_000 (Z.to_int (Q.den p) - 1) do
         let n = Rat.floor (Rat.mul (fst v) (Rat.of_int d)) in
         List.iter
           (fun n ->
              if is_near v (Rat.make n (Z.of_int d)) then Alcotest.failf "%s/%d is simpler" (Z.to_string n) d)
           [ n; Z.succ n ]
       done)
    [ q 1 4; q 30 1; q 1 1_000_000_000 ]

let known () =
  let check what expected step rate =
    Alcotest.(check string) what expected (Rat.to_string (Odds.within ~step rate))
  in
  check "never" "0" Rat.one Rat.zero;
  check "a rate of 2, eight times a unit of time" "107680/486801" (q 1 8) (q 2 1);
  check "as slow as you like: 10^-12" "1/1000000000000" Rat.one (Rat.make Z.one (Z.pow (Z.of_int 10) 12));
  Alcotest.(check bool) "the greatest: almost surely" true
    (Rat.compare (Odds.within ~step:Rat.one (q Odds.greatest 1)) Rat.one < 0)

(* Rates that compete are one rate together, of which each has its share; chances are what they are. *)
let shares () =
  let step = q 1 8 in
  let rate n : Odds.t = Rate { rate = Rat.of_int n; alone = Odds.within ~step (Rat.of_int n) } in
  let whole = Odds.within ~step (Rat.of_int 3) in
  let check what expected odds =
    Alcotest.(check (list string)) what (List.map Rat.to_string expected)
      (List.map Rat.to_string (Odds.shares ~step odds))
  in
  check "one alone" [ Odds.within ~step (Rat.of_int 2) ] [ rate 2 ];
  check "two" [ Rat.mul whole (q 2 3); Rat.mul whole (q 1 3) ] [ rate 2; rate 1 ];
  check "with a chance, and a rate that never happens"
    [ q 1 7; Rat.mul whole (q 1 3); Rat.zero; Rat.mul whole (q 2 3) ]
    [ Chance (q 1 7); rate 1; rate 0; rate 2 ]

let suite =
  ("odds",
   [
     ( "rates",
       Scc_test_support.Property.cases [ near ]
       @ [
         Alcotest.test_case "known values" `Quick known;
         Alcotest.test_case "the simplest ones" `Quick simplest;
         Alcotest.test_case "Lot: rates that compete" `Quick shares;
       ] );
   ])
