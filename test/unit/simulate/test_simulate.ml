(* What many values look like, against their definitions; and that runs are what the model checker says of them:
   exactly where nothing is drawn, and by so many deviations at most where something is. *)

open Scc_exact
open Scc_semantics
open Scc_runs
open Scc_export
open Scc_simulate
open Scc_test_support
open Scc_test_models

let same name a b = Alcotest.(check (list string)) name (List.map Rat.to_string a) (List.map Rat.to_string b)
let fraction n d = Rat.make (Z.of_int n) (Z.of_int d)

(* {1 Statistics} *)

let number = QCheck2.Gen.(map2 fraction (int_range (-20) 20) (int_range 1 6))
let print_all l = String.concat " " (List.map Rat.to_string l)
let sum = List.fold_left Rat.add Rat.zero
let collected = List.fold_left Statistics.add Statistics.empty

let by_definition (values, k) =
  let s = collected values and n = List.length values in
  let mean = Rat.div (sum values) (Rat.of_int n) in
  let square x = Rat.mul (Rat.sub x mean) (Rat.sub x mean) in
  let variance = if n < 2 then None else Some (Rat.div (sum (List.map square values)) (Rat.of_int (n - 1))) in
  let q = fraction k 8 in
  let not_above x = List.length (List.filter (fun y -> Rat.compare y x <= 0) values) in
  let enough x = Rat.compare (Rat.of_int (not_above x)) (Rat.mul q (Rat.of_int n)) >= 0 in
  let sorted = List.sort Rat.compare values in
  Statistics.count s = n
  && Rat.equal (Statistics.mean s) mean
  && Option.equal Rat.equal (Statistics.variance s) variance
  && Rat.equal (Statistics.least s) (List.hd sorted)
  && Rat.equal (Statistics.greatest s) (List.hd (List.rev sorted))
  && Rat.equal (Statistics.quantile s q) (List.find enough sorted)

let definitions =
  QCheck2.Test.make ~name:"mean, variance and quantiles" ~count:2_000
    ~print:(fun (l, k) -> Printf.sprintf "%s, %d/8" (print_all l) k)
    QCheck2.Gen.(pair (list_size (int_range 1 12) number) (int_bound 8))
    by_definition

(* The root is at most half a unit of its last place away. *)
let roots =
  QCheck2.Test.make ~name:"roots" ~count:2_000
    ~print:(fun (x, k) -> Printf.sprintf "%s to %d" (Rat.to_string x) k)
    QCheck2.Gen.(pair (map Rat.abs number) (int_bound 5))
    (fun (x, k) ->
       let unit = Rat.make Z.one (Z.pow (Z.of_int 10) k) in
       let text = Statistics.root ~decimals:k x in
       let digits = String.concat "" (String.split_on_char '.' text) in
       let r = Rat.mul (Rat.make (Z.of_string digits) Z.one) unit in
       let half = Rat.div unit (Rat.of_int 2) in
       let above = Rat.add r half and below = Rat.sub r half in
       Rat.compare x (Rat.mul above above) <= 0
       && (Rat.sign below < 0 || Rat.compare (Rat.mul below below) x <= 0)
       && (k = 0 || String.length text - String.index text '.' = k + 1))

(* {1 Plans} *)

let times () =
  let check name expected ~every ~until =
    same name expected (Array.to_list (Simulation.times ~every ~until))
  in
  check "the end is a multiple" [ Rat.zero; fraction 1 2; Rat.one ] ~every:(fraction 1 2) ~until:Rat.one;
  check "and is none" [ Rat.zero; fraction 2 3; Rat.one ] ~every:(fraction 2 3) ~until:Rat.one;
  check "at once" [ Rat.zero ] ~every:Rat.one ~until:Rat.zero;
  Alcotest.(check bool) "a million" false (Simulation.too_many ~every:Rat.one ~until:(Rat.of_int 1_000_000));
  Alcotest.(check bool) "and one" true (Simulation.too_many ~every:Rat.one ~until:(Rat.of_int 1_000_001))

let seeds () =
  List.iter
    (fun seed ->
       let rec outputs n g = if n = 0 then [] else let x, g = Splitmix64.next g in x :: outputs (n - 1) g in
       let expected = outputs 100 (Splitmix64.of_seed seed) in
       Alcotest.(check (list int64)) "the outputs" expected (List.init 100 (Simulation.seed_of seed)))
    [ 0L; 1L; -1L; Int64.max_int; Int64.min_int ]

(* {1 Runs} *)

let folder = "../../../specs/models/"

(* What the model checker says of the mean of this at each of the times. *)
let expected file text times =
  let question i t = Printf.sprintf "check asked%d : E = ? [ %s at %s ]\n" i text (Rat.to_string t) in
  let questions = List.mapi question times in
  let e = Load.exactly (Load.text (Load.read (folder ^ file) ^ "\n" ^ String.concat "" questions)) in
  let semantics = Scc_engine.Standard.of_model e.model in
  let checks = List.filter (fun (c : Scc_property.Property.check) -> c.asked <> Whether) e.checks in
  let is_mine (c : Scc_property.Property.check) = String.length c.name > 5 && String.sub c.name 0 5 = "asked" in
  let checks = List.filter is_mine checks in
  let initial = Result.get_ok (Network.initial semantics e.declared) in
  let outcome (o : Scc_verify.Verdict.outcome) =
    match o.verdict with
    | Measured { values = (_, { Scc_ctl.Eval.least = Scc_chance.Answer.Exact x; _ }) :: _; _ } -> x
    | _ -> Alcotest.failf "%s: %s is not known" file o.check.text
  in
  List.map outcome (Scc_verify.Check.run Scc_verify.Setup.default semantics ~initial checks).outcomes

let plan file text times =
  let e = Load.exactly (Load.text (Load.read (folder ^ file) ^ "\ncheck asked : E = ? [ " ^ text ^ " at 1 ]\n")) in
  let number =
    List.find_map
      (fun (c : Scc_property.Property.check) ->
         match c.asked with Expected (_, Value_at (n, _), _) when c.name = "asked" -> Some n | _ -> None)
      e.checks
  in
  let observables = [ { Table.text; what = Number (Option.get number) } ] in
  {
    Simulation.semantics = Scc_engine.Standard.of_model e.model;
    declared = e.declared;
    observables;
    times = Array.of_list times;
    steps = None;
  }

let never () = false
let value (r : Simulation.run) i = Option.get r.values.(i).(0)

let certain (file, text, times) () =
  let times = List.map (fun (n, d) -> fraction n d) times in
  let run : Simulation.run = Simulation.run (plan file text times) ~seed:11L ~interrupted:never 0 in
  Alcotest.(check (option string)) "it comes to the last time" None run.ended;
  same text (expected file text times) (List.mapi (fun i _ -> value run i) times)

(* An interruption before any transition leaves values of the whole run up to some time, the more the later it
   is. *)
let cut (file, text, times) () =
  let plan = plan file text (List.map (fun (n, d) -> fraction n d) times) in
  let whole : Simulation.run = Simulation.run plan ~seed:11L ~interrupted:never 0 in
  let rec prefix a b =
    match (a, b) with
    | Some x :: a, Some y :: b -> Rat.equal x y && prefix a b
    | rest, _ -> List.for_all Option.is_none rest
  in
  let known (r : Simulation.run) = List.map (fun row -> row.(0)) (Array.to_list r.values) in
  let count r = List.length (List.filter Option.is_some (known r)) in
  let rec go n before =
    let left = ref n in
    let interrupted () =
      decr left;
      !left < 0
    in
    let run : Simulation.run = Simulation.run plan ~seed:11L ~interrupted 0 in
    Alcotest.(check bool) "values of the whole run" true (prefix (known run) (known whole));
    Alcotest.(check bool) "more and more" true (count run >= before);
    Alcotest.(check bool) "it says so" run.interrupted
      (Option.fold ~none:false ~some:(String.starts_with ~prefix:(Printf.sprintf "interrupted after %d tran" n))
         run.ended);
    if run.interrupted then go (n + 1) (count run) else (n, run)
  in
  let n, last = go 0 0 in
  Alcotest.(check bool) "some are interrupted" true (n > 1);
  Alcotest.(check bool) "the last is whole" true (count last = count whole && last.ended = whole.ended)

(* The mean of n independent values is hardly ever more than five of its deviations from theirs. *)
let drawn (file, text, times) () =
  let times = List.map (fun (n, d) -> fraction n d) times in
  let plan = plan file text times and count = 3_000 in
  let runs = List.init count (Simulation.run plan ~seed:2026L ~interrupted:never) in
  let check i exact =
    let s = collected (List.map (fun r -> value r i) runs) in
    let off = Rat.sub (Statistics.mean s) exact in
    let variance = Option.get (Statistics.variance s) in
    let allowed = Rat.mul (Rat.of_int 25) (Rat.div variance (Rat.of_int count)) in
    if Rat.compare (Rat.mul off off) allowed > 0 then
      Alcotest.failf "%s: %s at %s is %s on the average, and not %s" file text
        (Rat.to_string (List.nth times i))
        (Rat.to_string (Statistics.mean s))
        (Rat.to_string exact)
  in
  List.iteri check (expected file text times)

let deterministic =
  [
    ("billiard.sc", "x(p)", [ (0, 1); (1, 7); (3, 2); (2, 1); (7, 3) ]);
    ("gravity.sc", "energy", [ (0, 1); (1, 3); (5, 4) ]);
  ]

let random =
  [
    ("ruin.sc", "if gone(walker) then 0 else x(walker)", [ (1, 2); (3, 1); (13, 2); (20, 1) ]);
    ("ruin.sc", "if gone(walker) then 1 else 0", [ (2, 1); (3, 1); (10, 1) ]);
    ("brownian.sc", "x(ligand) * x(ligand)", [ (1, 1); (5, 2); (6, 1) ]);
  ]

let () =
  let case name f = Alcotest.test_case name `Quick f in
  let with_name f ((file, text, _) as what) = case (file ^ ": " ^ text) (f what) in
  Alcotest.run "simulate"
    [
      ("statistics", Property.cases [ definitions; roots ]);
      ("plans", [ case "times" times; case "seeds" seeds ]);
      ("runs without draws", List.map (with_name certain) deterministic);
      ("interrupted runs", List.map (with_name cut) (deterministic @ random));
      ("runs with draws", List.map (with_name drawn) random);
    ]
