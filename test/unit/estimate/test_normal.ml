(* Approximate intervals: quantiles, how often they miss by counting, and what they are refused for. *)

open Scc_exact
open Scc_runs
open Scc_estimate
open Counting

let quantiles () =
  let check miss expected =
    Alcotest.(check string) (Rat.to_string miss) expected (Decimal.fixed ~places:6 (Normal_mean.quantile miss))
  in
  (* as in tables, rounded up in the ninth digit *)
  check (fraction 1 20) "1.959964";
  check (fraction 1 100) "2.575829";
  check (fraction 1 1000) "3.290527";
  check (fraction 1 1_000_000) "4.891638";
  check (fraction 1 2) "0.67449"

let estimate ?(confidence = fraction 19 20) ?(width = fraction 1 1000) ~size text numbers =
  let aim = { Estimation.confidence; width; size; free = Sample.Apart; normal = true } in
  let t = Estimation.start aim [ path text ] in
  let rec go made =
    match Estimation.next t with
    | None -> List.hd (Estimation.answers t)
    | Some n ->
      for i = made to n - 1 do
        Estimation.add t { Sample.outcomes = [ Number (numbers i) ]; chosen = false; interrupted = false }
      done;
      Estimation.judge t ~last:false;
      go n
  in
  go 0

let place = "E = ? [ x(a) at 1 ]"

(* Numbers of trials until a success of the probability 1/3, less 3: of the mean 0, and not symmetric. *)
let trials seed =
  let g = ref (Splitmix64.of_seed seed) in
  let rec more n =
    let success, next = coin (fraction 1 3) !g in
    g := next;
    if success then n else more (n + 1)
  in
  fun _ -> Rat.of_int (more 1 - 3)

(* The confidence is that of a normal mean. Of 400 runs of this number it is nearly so: 1/15 may miss for 1/20. *)
let coverage size () =
  let count = 300 in
  let misses seed =
    match (estimate ~size place (trials (Int64.of_int seed))).value with
    | Approximate { low; high; _ } -> Rat.sign low > 0 || Rat.sign high < 0
    | _ -> Alcotest.fail "no interval"
  in
  let missed = List.length (List.filter misses (List.init count Fun.id)) in
  few_missed "normal" ~count ~miss:(fraction 1 15) missed

(* Whatever the number of runs: values that are alike have no interval, also of width 0. *)
let alike () =
  let none numbers size =
    let a = estimate ~size place numbers in
    Alcotest.(check bool) "sampled, and why" true
      (a.verdict = Sampled && a.reasons <> [] && match a.value with Sample _ -> true | _ -> false)
  in
  List.iter
    (fun numbers -> List.iter (none numbers) [ Exactly 1; Exactly 20; Exactly 4_000; At_most 10; At_most 3_000 ])
    [ (fun _ -> fraction 7 3); (fun i -> Rat.of_int (if i mod 200 = 199 then 1000 else 0)) ]

(* Runs that were interrupted are the long ones: the others alone have no interval. *)
let interrupted () =
  let outcome i = if i mod 50 = 49 then Sample.Too_long Interruption else Number (Rat.of_int (i mod 7)) in
  let confidence = fraction 19 20 and size = Estimation.Exactly 500 in
  let aim = { Estimation.confidence; width = fraction 1 2; size; free = Apart; normal = true } in
  let t = Estimation.start aim [ path place ] in
  for i = 0 to 499 do
    Estimation.add t { Sample.outcomes = [ outcome i ]; chosen = false; interrupted = false }
  done;
  Estimation.judge t ~last:true;
  let a = List.hd (Estimation.answers t) in
  Alcotest.(check bool) "sampled, and why" true
    (a.verdict = Sampled && a.reasons <> [] && match a.value with Sample _ -> true | _ -> false)

(* A range with one end bounds the interval, and one with both is that of the proved bounds. *)
let ranges () =
  let value text numbers = (estimate ~size:(Exactly 4_000) text numbers).value in
  let rare i = Rat.of_int (if i mod 100 = 99 then 1000 else 0) in
  (match value "E = ? [ time U x(a) >= 3 ]" rare with
   | Approximate { low; mean; high } ->
     Alcotest.(check bool) "around the mean" true (Rat.compare low mean < 0 && Rat.compare mean high < 0);
     Alcotest.(check bool) "not below 0" true (Rat.sign low >= 0)
   | _ -> Alcotest.fail "one end");
  match value "E = ? [ max(-1, min(x(a), 1)) at 1 ]" (fun i -> Rat.of_int ((i mod 3) - 1)) with
  | Mean { low = Some _; high = Some _; _ } -> ()
  | _ -> Alcotest.fail "both ends"

let decided () =
  let verdict text = (estimate ~size:(At_most 10_000) text (trials 3L)).verdict in
  let check text expected = Alcotest.(check bool) text true (verdict text = expected) in
  check "E <= 1 [ x(a) at 1 ]" Estimation.Holds;
  check "E < -1 [ x(a) at 1 ]" Violated;
  check "E <= 0 [ x(a) at 1 ]" Undecided

let () =
  let case = Alcotest.test_case in
  Alcotest.run "normal"
    [
      ( "Normal",
        [
          case "quantiles" `Quick quantiles;
          case "Normal: coverage by counting, once" `Quick (coverage (Exactly 400));
          case "coverage by counting, again and again" `Quick (coverage (At_most 400));
          case "Normal: values that are alike" `Quick alike;
          case "runs that are left out" `Quick interrupted;
          case "ranges" `Quick ranges;
          case "comparisons" `Quick decided;
        ] );
    ]
