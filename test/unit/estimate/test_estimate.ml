(* Intervals against the distributions that they are about; that they cover what they should as often as they
   say; and single runs against the rules for all runs. *)

open Scc_exact

open Scc_semantics
open Scc_runs
open Scc_estimate
open Scc_test_support
open Scc_test_models
open Counting

(* P(X = k), P(X >= k) of n trials. *)
let exactly n k p =
  Rat.mul (Rat.make (Z.bin (Z.of_int n) k) Z.one) (Rat.mul (power p k) (power (Rat.sub Rat.one p) (n - k)))

let at_least n k p = List.fold_left Rat.add Rat.zero (List.init (n - k + 1) (fun i -> exactly n (k + i) p))

(* {1 Clopper and Pearson} *)

(* By the whole distribution: the tail is small enough at the end, and not two units above it (one unit above it
   may be just as much, which no rounding proves). *)
let ends =
  QCheck2.Test.make ~name:"the ends are where the tails are as they should be" ~count:200 ~print small
    (fun (n, k, m) ->
       let miss = fraction m 1000 in
       let low = Clopper_pearson.lower ~n ~k ~miss and high = Clopper_pearson.upper ~n ~k ~miss in
       let enough p = Rat.compare (at_least n k p) miss <= 0 in
       (k = 0 && Rat.sign low = 0)
       || (enough low && not (enough (Rat.add low (Rat.mul (Rat.of_int 2) Clopper_pearson.unit))))
          && Rat.equal high (Rat.sub Rat.one (Clopper_pearson.lower ~n ~k:(n - k) ~miss)))

let tails =
  QCheck2.Test.make ~name:"tails are never said to be less than they are" ~count:200
    ~print:(fun (s, p) -> print s ^ Printf.sprintf ", p = %d/97" p)
    QCheck2.Gen.(pair small (int_bound 97))
    (fun ((n, k, m), p) ->
       let miss = fraction m 1000 and p = fraction p 97 in
       (not (Tail.at_most (Tail.coefficient ~n ~k) ~chance:p miss)) || Rat.compare (at_least n k p) miss <= 0)

(* For every probability, all results that miss it together are not likelier than they may be. *)
let covers =
  QCheck2.Test.make ~name:"coverage, by the whole distribution" ~count:30
    ~print:(fun (n, p) -> Printf.sprintf "n = %d, p = %d/211" n p)
    QCheck2.Gen.(pair (int_range 1 40) (int_bound 211))
    (fun (n, p) ->
       let p = fraction p 211 and half = fraction 1 40 in
       let missed k =
         Rat.compare p (Clopper_pearson.lower ~n ~k ~miss:half) < 0
         || Rat.compare p (Clopper_pearson.upper ~n ~k ~miss:half) > 0
       in
       let add sum k = if missed k then Rat.add sum (exactly n k p) else sum in
       Rat.compare (List.fold_left add Rat.zero (List.init (n + 1) Fun.id)) (fraction 1 20) <= 0)

let known () =
  let check n k (low, high) =
    let miss = fraction 1 40 in
    let text r = Decimal.fixed ~places:3 r in
    Alcotest.(check (pair string string))
      (Printf.sprintf "%d of %d" k n) (low, high)
      (text (Clopper_pearson.lower ~n ~k ~miss), text (Clopper_pearson.upper ~n ~k ~miss))
  in
  (* the intervals of 95 % in tables *)
  check 10 3 ("0.067", "0.652");
  check 100 0 ("0", "0.036");
  check 100 100 ("0.964", "1");
  check 1000 500 ("0.469", "0.531")

(* {1 Coverage by counting} *)

(* One estimate of coins that are thrown: the answer. *)
let estimate aim path p g =
  let t = Estimation.start aim [ path ] in
  let rec throw n g =
    if n = 0 then g
    else
      let side, g = coin p g in
      Estimation.add t { Sample.outcomes = [ Truth side ]; chosen = false; interrupted = false };
      throw (n - 1) g
  in
  let rec go made g =
    match Estimation.next t with
    | None -> (List.hd (Estimation.answers t), g)
    | Some n ->
      let g = throw (n - made) g in
      Estimation.judge t ~last:false;
      go n g
  in
  go 0 g

let missed p (a : Estimation.answer) =
  match a.value with
  | Probability (low, high) -> Rat.compare p low < 0 || Rat.compare p high > 0
  | Mean _ | Approximate _ | Sample _ | Infinite | Unknown -> Alcotest.fail "no probability"

let counted what ~count size p () =
  let miss = fraction 1 20 in
  let confidence = Rat.sub Rat.one miss in
  let aim = { Estimation.confidence; width = fraction 1 5; size; free = Sample.Apart; normal = false } in
  let path = path "P = ? [ eventually x(a) >= 1 ]" in
  let rec go i g wrong =
    if i = count then wrong
    else
      let a, g = estimate aim path p g in
      go (i + 1) g (if missed p a then wrong + 1 else wrong)
  in
  let wrong = go 0 (Splitmix64.of_seed 17L) 0 in
  few_missed what ~count ~miss wrong

(* What is known of one look, of which the interval depends on the number of successes alone. *)
let intervals ~count n p () =
  let miss = fraction 1 20 in
  let misses k =
    let tally = List.init n (fun i -> Sample.Truth (i < k)) |> List.fold_left Tally.add Tally.empty in
    let low, high = Tally.likelihood tally ~miss in
    Rat.compare p low < 0 || Rat.compare p high > 0
  in
  let misses = Array.init (n + 1) misses in
  let rec successes left found g =
    if left = 0 then (found, g)
    else
      let side, g = coin p g in
      successes (left - 1) (if side then found + 1 else found) g
  in
  let rec go i g wrong =
    if i = count then wrong
    else
      let k, g = successes n 0 g in
      go (i + 1) g (if misses.(k) then wrong + 1 else wrong)
  in
  few_missed "intervals" ~count ~miss (go 0 (Splitmix64.of_seed 17L) 0)

(* Comparisons: how often the answer is wrong. *)
let decided () =
  let miss = fraction 1 20 and count = 400 in
  let confidence = Rat.sub Rat.one miss in
  let aim = { Estimation.confidence; width = fraction 1 20; size = At_most 2000; free = Apart; normal = false } in
  List.iter
    (fun (bound, p, right) ->
       let path = path (Printf.sprintf "P >= %s [ eventually x(a) >= 1 ]" bound) in
       let rec go i g wrong decided =
         if i = count then (wrong, decided)
         else
           let a, g = estimate aim path p g in
           let is_wrong = match a.verdict with Undecided -> false | v -> v <> right in
           let more yes n = if yes then n + 1 else n in
           go (i + 1) g (more is_wrong wrong) (more (a.verdict = right) decided)
       in
       let wrong, found = go 0 (Splitmix64.of_seed 5L) 0 0 in
       few_missed bound ~count ~miss wrong;
       Alcotest.(check bool) (bound ^ ": most are decided") true (2 * found > count))
    [ ("1/2", fraction 3 5, Estimation.Holds); ("1/2", fraction 2 5, Violated); ("9/10", fraction 39 40, Holds) ]

(* Stopped before the first run has come to its end. *)
let no_runs () =
  let check text line =
    List.iter
      (fun size ->
         let confidence = fraction 19 20 in
         let aim = { Estimation.confidence; width = fraction 1 20; size; free = Apart; normal = false } in
         let t = Estimation.start aim [ path text ] in
         Estimation.judge t ~last:true;
         let told = List.map (Estimate_report.line ~confidence) (Estimation.answers t) in
         Alcotest.(check (list string)) text [ line ] told)
      [ Estimation.Exactly 15; At_most 2000 ]
  in
  check "P = ? [ eventually x(a) >= 1 ]" "not known, 0 runs";
  check "P >= 1 [ eventually x(a) >= 1 ]" "not known, 0 runs";
  check "E = ? [ time U x(a) >= 1 ]" "not known, 0 runs";
  check "E <= 1 [ x(a) at 1 ]" "not known, 0 runs"

(* {1 Runs} *)

let folder = "../../../specs/models/"

let sampled ?(free = Sample.Apart) ?steps ?(interrupted = fun () -> false) text property ~runs =
  let e = Load.exactly (Load.text (text ^ "\ncheck asked : " ^ property ^ "\n")) in
  let check = List.find (fun (c : Scc_property.Property.check) -> c.name = "asked") e.checks in
  let path = Result.get_ok (Path.of_check e.model check) in
  let semantics = Scc_engine.Standard.of_model e.model in
  let plan = { Sample.semantics; declared = e.declared; paths = [ path ]; free; steps; until = None } in
  let initial = Result.get_ok (Network.initial semantics e.declared) in
  let checked =
    match (Scc_verify.Check.run Scc_verify.Setup.default semantics ~initial [ check ]).outcomes with
    | [ { verdict = Measured { values; _ }; _ } ] -> List.map (fun (_, (m : Scc_ctl.Eval.measured)) -> m) values
    | _ -> []
  in
  (List.init runs (Sample.run plan ~seed:3L ~interrupted), checked)

let outcome : Sample.outcome -> string = function
  | Truth b -> string_of_bool b
  | Number r -> Rat.to_string r
  | Never -> "never"
  | Free Elsewhere -> "free"
  | Free Splits -> "free, at splits"
  | Free Walkers_bounce -> "free, where walkers bounce"
  | Too_long _ -> "too long"
  | No_value why -> "no value: " ^ why

let model name = Load.read (folder ^ name)

let hand () =
  let check ?free ?steps name text property expected =
    let runs, _ = sampled ?free ?steps text property ~runs:1 in
    let found =
      match runs with
      | [ { Sample.outcomes = [ o ]; chosen; _ } ] -> (outcome o, chosen)
      | _ -> ("", false)
    in
    Alcotest.(check (pair string bool)) (name ^ ": " ^ property) expected found
  in
  let straight = "import <solids>\nprocess a = solids.Cube(1) mass 1 velocity (2, 0, 0) [nil]" in
  check "straight" straight "P = ? [ eventually x(a) > 5 ]" ("true", false);
  check "straight" straight "P = ? [ eventually x(a) > 5 within 5/2 ]" ("false", false);
  check "straight" straight "P = ? [ eventually x(a) >= 5 within 5/2 ]" ("true", false);
  check "straight" straight "P = ? [ always x(a) >= 0 ]" ("true", false);
  check "straight" straight "P = ? [ x(a) < 3 U x(a) = 3 ]" ("true", false);
  check "straight" straight "P = ? [ x(a) < 3 U x(a) > 3 ]" ("false", false);
  check "straight" straight "E = ? [ time U x(a) >= 7/3 ]" ("7/6", false);
  check "straight" straight "E = ? [ time U x(a) < 0 ]" ("never", false);
  check "straight" straight "E = ? [ x(a) at 5/4 ]" ("5/2", false);
  check "straight" straight "E = ? [ event bounce U x(a) > 9 ]" ("0", false);
  (* weak splits are free *)
  check "dimer" (model "dimer.sc") "P = ? [ eventually bonds() = 0 ]" ("free", false);
  check "dimer" (model "dimer.sc") ~free:Evenly "P = ? [ eventually bonds() = 0 ]" ("true", true);
  check "dimer" (model "dimer.sc") "P = ? [ always bonds() = 2 within 1 ]" ("true", false);
  check "billiard" (model "billiard.sc") ~steps:3 "P = ? [ eventually bonds() = 1 ]" ("too long", false);
  check "gone" (model "ruin.sc") "E = ? [ x(walker) at 1000 ]"
    ("no value: `walker` is gone, and nowhere: ask for `gone(walker)` first", false)

(* The mean of what single runs say is near what is true of all of them, within five deviations. *)
let near file property () =
  let count = 2_000 in
  let runs, checked = sampled (model file) property ~runs:count in
  let exact =
    match checked with
    | { least = Exact x; _ } :: _ -> x
    | _ -> Alcotest.failf "%s: %s is not known" file property
  in
  let number (r : Sample.run) =
    match r.outcomes with
    | [ Truth true ] when not r.chosen -> Rat.one
    | [ Truth false ] when not r.chosen -> Rat.zero
    | [ Number x ] when not r.chosen -> x
    | os -> Alcotest.failf "%s: %s: %s" file property (String.concat " " (List.map outcome os))
  in
  let s = List.fold_left Scc_simulate.Statistics.add Scc_simulate.Statistics.empty (List.map number runs) in
  let off = Rat.sub (Scc_simulate.Statistics.mean s) exact in
  let variance = Option.get (Scc_simulate.Statistics.variance s) in
  if Rat.compare (Rat.mul (Rat.of_int count) (Rat.mul off off)) (Rat.mul (Rat.of_int 25) variance) > 0 then
    Alcotest.failf "%s: %s is %s on the average, and not %s" file property
      (Rat.to_string (Scc_simulate.Statistics.mean s))
      (Rat.to_string exact)

(* What is asked of some bodies is found from them alone, and in the whole network if something else needs it. *)
let crowd =
  "timestep 1 steady\nimport <solids>\nfixed room = solids.Room(8, 8, 1, 1)\n\
   behaviour A = <a, {right}> . omega(a, {right}) . A\nbehaviour B = <~a, {left}> . omega(a, {left}) . B\n\
   for i in 1..3 { process c[i] = solids.Cube(1) mass 1 at translate (-9/2 + 2*i, 3/2, 0) [A] }\n\
   for i in 1..3 { process d[i] = solids.Cube(1) mass 1 at translate (-7/2 + 2*i, -3/2, 0) [B] }\n\
   fixed sink = solids.Cube(1) absorb at translate (7/2, 7/2, 0)\n\
   motion choose { (1,0,0), (-1,0,0), (0,1,0), (0,-1,0) }\n"

let asked_of_some =
  [
    "P = ? [ eventually bound(c[1], d[2]) within 9 ]"; "P = ? [ eventually event bounce(c[2], d[2]) within 5 ]";
    "P = ? [ eventually event bounce within 1 ]"; "P = ? [ eventually event absorb(d[3], sink) within 9 ]";
    "P = ? [ not touching(c[2], c[3]) U[1, 6] x(c[2]) > 1 ]"; "P = ? [ eventually gone(c[3]) within 9 ]";
    "P = ? [ always distance2(c[1], d[1]) > 1 and speed2(c[1]) <= 2 within 6 ]";
    "P = ? [ eventually same(c[1], d[1]) and size(c[1]) > 2 within 9 ]";
    "E = ? [ event bounce(c[2]) U time >= 4 ]"; "E = ? [ x(c[1]) - vx(d[1]) at 5 ]";
    "E = ? [ time U x(c[2]) >= 3/2 or y(c[2]) < 0 ]";
    "E = ? [ if offers(c[1], a) then bonds(a, c[1], d[1]) else 2 at 7 ]";
  ]

let parts () =
  let check i text = Printf.sprintf "check q%d : %s\n" i text in
  let whole = "P = ? [ eventually energy < 0 within 1 ]" in
  let e = Load.exactly (Load.text (crowd ^ String.concat "" (List.mapi check (asked_of_some @ [ whole ])))) in
  let paths = List.map (fun c -> Result.get_ok (Path.of_check e.model c)) e.checks in
  let everything = List.nth paths (List.length asked_of_some) in
  let semantics = Scc_engine.Standard.of_model e.model in
  Alcotest.(check bool) "from event to event" true (Scc_engine.Event_run.can_run e.model);
  Alcotest.(check bool) "a whole network" true (Path.seen [ everything ] = None);
  let outcomes paths =
    let steps = Some 5_000 in
    let plan = { Sample.semantics; declared = e.declared; paths; free = Evenly; steps; until = None } in
    List.init 15 (fun k ->
        outcome (List.hd (Sample.run plan ~seed:7L ~interrupted:(fun () -> false) k).outcomes))
  in
  let several =
    List.map2
      (fun path text ->
         Alcotest.(check bool) (text ^ ": of some bodies") true (Path.seen [ path ] <> None);
         let found = outcomes [ path ] in
         Alcotest.(check (list string)) text (outcomes [ path; everything ]) found;
         List.length (List.sort_uniq String.compare found) > 1)
      (Scc_data.Lists.take (List.length asked_of_some) paths)
      asked_of_some
  in
  Alcotest.(check bool) "most have several outcomes" true (List.length (List.filter Fun.id several) >= 8)

(* What an interrupted run decides is what the whole one does; nothing else is decided. *)
let cut file property () =
  let single interrupted =
    match sampled ~interrupted (model file) property ~runs:1 with
    | [ { Sample.outcomes = [ o ]; interrupted; _ } ], _ -> (o, interrupted)
    | _ -> Alcotest.fail "no single run"
  in
  let whole, _ = single (fun () -> false) in
  let rec go n opens =
    let left = ref n in
    let interrupted () =
      decr left;
      !left < 0
    in
    match single interrupted with
    | Too_long Interruption, true -> go (n + 1) (opens + 1)
    | found, cut ->
      Alcotest.(check string) (Printf.sprintf "interrupted after %d" n) (outcome whole) (outcome found);
      if cut then go (n + 1) opens else opens
  in
  Alcotest.(check bool) "some are open" true (go 0 0 > 0)

(* A run that was interrupted is open where a range is known, and else left out, and the answer says so. What the
   other runs came to is said as well. *)
let open_runs () =
  let body = "import <solids>\nprocess a = solids.Cube(1) mass 1 [nil]\n" in
  let answer property outcomes =
    let e = Load.exactly (Load.text (body ^ "check c : " ^ property ^ "\n")) in
    let path = Result.get_ok (Path.of_check e.model (List.hd e.checks)) in
    let confidence = fraction 19 20 and size = Estimation.Exactly 9 in
    let aim = { Estimation.confidence; width = fraction 1 20; size; free = Evenly; normal = false } in
    let t = Estimation.start aim [ path ] in
    let add o = Estimation.add t { Sample.outcomes = [ o ]; chosen = false; interrupted = true } in
    List.iter add outcomes;
    Estimation.judge t ~last:true;
    List.hd (Estimation.answers t)
  in
  let check property outcomes (runs, lines) =
    let a = answer property outcomes in
    let found = Estimate_report.of_known a @ a.reasons in
    Alcotest.(check (pair int (list string))) property (runs, lines) (a.tally.runs, found)
  in
  let cut = Sample.Too_long Interruption and number n = Sample.Number (Rat.of_int n) in
  let stopped = " left before it was known: the command was stopped" in
  let one_open = "; 1 run is open, and may differ" and two_open = "; 2 runs are open, and may differ" in
  let no_upper =
    "no greatest value of this number is known, and so no upper end: a value too rare to be among the runs may \
     raise the mean by any amount"
  in
  check "P = ? [ eventually x(a) >= 1 ]" [ Truth true; Truth false; cut ]
    (3, [ "it is so in 1 of the 2 runs that tell" ^ one_open; "1 of 3 runs was" ^ stopped ]);
  check "P = ? [ eventually x(a) >= 1 ]" [ Truth true; cut; Truth false; cut ]
    (4, [ "it is so in 1 of the 2 runs that tell" ^ two_open; "2 of 4 runs were" ^ stopped ]);
  check "P = ? [ eventually x(a) >= 1 ]" [ Truth true; Truth false ] (2, []);
  check "P < 1/1000 [ eventually x(a) >= 1 ]" (cut :: List.init 8 (fun _ -> Sample.Truth true)) (9, []);
  check "E = ? [ time U x(a) >= 1 ]" [ number 2; number 5; cut ]
    (3, [ "the mean of the 2 runs with a number is 3.5" ^ one_open; no_upper; "1 of 3 runs was" ^ stopped ]);
  check "E = ? [ if x(a) > 0 then 3 else 0 at 1 ]" [ number 3; cut; cut; number 0; number 3 ]
    (5, [ "the mean of the 3 runs with a number is 2" ^ two_open; "2 of 5 runs were" ^ stopped ]);
  check "E = ? [ x(a) at 1 ]" [ cut; cut ] (0, [ "2 more runs are left out, which were interrupted" ])

let () =
  let case name f = Alcotest.test_case name `Quick f in
  let near file property = case (file ^ ": " ^ property) (near file property) in
  Alcotest.run "estimate"
    [
      ("distributions", Property.cases [ ends; tails; covers ] @ [ case "tables" known ]);
      ( "counted",
        [
          case "10 000 intervals of 60 throws" (intervals ~count:10_000 60 (fraction 171 211));
          case "500 intervals in looks" (counted "looks" ~count:500 (At_most 1_000) (fraction 1 3));
          case "comparisons" decided; case "no runs" no_runs;
        ] );
      ( "interrupted runs",
        [
          case "ruin" (cut "ruin.sc" "P = ? [ eventually gone(walker) within 4 ]");
          case "a time" (cut "ruin.sc" "E = ? [ time U gone(walker) ]"); case "answers" open_runs;
        ] );
      ("single runs", [ case "by hand" hand; case "some bodies of many" parts ]);
      ( "beside the model checker",
        [
          near "ruin.sc" "P = ? [ eventually event absorb(walker, ruin) ]";
          near "ruin.sc" "P = ? [ eventually gone(walker) within 4 ]";
          near "ruin.sc" "P = ? [ not gone(walker) U[3, 6] gone(walker) ]";
          near "ruin.sc" "E = ? [ time U gone(walker) ]";
          near "ruin.sc" "E = ? [ x(walker) at 3/2 ]";
          near "brownian.sc" "E = ? [ x(ligand) * y(ligand) at 6 ]";
        ] );
    ]
