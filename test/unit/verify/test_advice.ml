(* What is advised, against the bound that ended the exploration: nothing where all is decided, and nothing that
   another bound would make useless. *)

open Scc_exact
open Scc_graph_search
open Scc_semantics
open Scc_verify
open Scc_test_models

let bounds = { Bounds.default with bits = Default 3000 }

let stopped (stop : Limits.stop) after =
  let asked = ref 0 in
  let stop () =
    incr asked;
    if !asked > after then Some stop else None
  in
  Limits.undivided ~stop ()

(* Seconds and memory are over when they were asked about so often. *)
let options =
  let within bounds = { Setup.default with bounds } in
  let ended bounds stop after = { (within bounds) with surroundings = stopped stop after } in
  let seconds = { bounds with seconds = Given 1. } and memory = { bounds with memory = Given 1_000_000 } in
  List.concat_map
    (fun n ->
       [
         (Printf.sprintf "%d states" n, within { bounds with states = Given n });
         (Printf.sprintf "depth %d" n, within { bounds with depth = Given n; states = Given 150 });
         (Printf.sprintf "time %d" n, within { bounds with time = Given (Rat.of_int n); states = Given 150 });
         (Printf.sprintf "seconds, asked %d times" n, ended seconds Seconds n);
         (Printf.sprintf "memory, asked %d times" n, ended memory Memory n);
         (Printf.sprintf "interrupted, asked %d times" n, ended bounds Interrupted n);
       ])
    [ 1; 60 ]
  @ [
    ("60 bits", within { bounds with bits = Given 60; states = Given 150 });
    ("an instant", within { bounds with instant = Given 2; states = Given 150 });
  ]

(* The last checks of each are decided soon, and the first ones by no bound that is tried here. *)
let walls =
  {|
shape C = box(1,1,1)
process p = C mass 1 velocity (1,0,0) [nil]
fixed w1 = C at translate (-2,0,0)
fixed w2 = C at translate (2,0,0)
process q = C mass 1 velocity (0,1,0) at translate (0,9,0) [nil]
|}

let drawn =
  {|
timestep 1 steady
process w = box(1/4, 1/4, 1/4) mass 1 [nil]
motion w = choose { (1, 0, 0) weight 1, (-1, 0, 0) weight 1 }
|}

let by_place =
  {|
timestep 1 steady
process w = box(1/4, 1/4, 1/4) mass 1 [nil]
motion w = choose { (1 + x, 0, 0), (-1, 0, 0) }
|}

let growing = "process p = box(1, 1, 1) mass 1 velocity (1,0,0) [nil]\nmotion p = (vx * vx * 3, 0, 0)\n"

let models =
  [
    (walls, "EF AG y(q) > 1000000", "EF (vx(p) = -1 and EF vx(p) = 1)");
    (walls, "possibly y(q) > 1000000", "possibly x(p) = 0");
    (drawn, "P = ? [ eventually x(w) > 200 within 400 ]", "EF x(w) = 1");
    (drawn, "P = ? [ eventually x(w) > 2000 ]", "P >= 1/2 [ eventually x(w) = 1 within 1 ]");
    (drawn, "P >= 1 [ eventually abs(x(w)) > 2000 ]", "EF EF x(w) = 1");
    (drawn, "E = ? [ if x(w) > 0 then 1 else 0 at 400 ]", "EF x(w) = 0");
    (drawn, "E = ? [ x(w) at 400 ]", "EF x(w) = 0");
    (growing, "EF AG x(p) < 0", "EF x(p) >= 0");
  ]

let run (options : Setup.t) text =
  let e = Load.exactly (Load.text text) in
  let semantics = Scc_engine.Standard.of_model e.model in
  match Network.initial semantics e.declared with
  | Ok initial -> ((e.model, e.declared), Check.run options semantics ~initial e.checks)
  | Error _ -> Alcotest.fail "no initial state"

let limit_is test (t : Verdict.truncation) = test t.limit
let of_resources = limit_is (function States _ | Bits _ | Seconds _ | Memory _ | Interrupted -> true | _ -> false)
let of_bits = limit_is (function Bits _ -> true | _ -> false)
let of_size = limit_is (function States _ | Seconds _ | Memory _ | Interrupted -> true | _ -> false)
let advised = ref 0 and silent = ref 0 and cures = ref 0

let judge what (model, from) (r : Check.report) =
  let is message = Alcotest.(check bool) (what ^ ": " ^ message) true in
  let s = r.stats in
  let told = s.causes <> [] || Option.is_some s.growth || Option.is_some s.converges in
  let bounded (o : Verdict.outcome) = Verdict.truncated o.verdict <> [] in
  incr (if told then advised else silent);
  is "nothing where all is decided" ((not told) || List.exists bounded r.outcomes);
  is "causes of a bound that they lead to" (s.causes = [] || List.exists of_resources s.stopped_by);
  is "bits where they were met" (Option.is_none s.growth || List.exists of_bits s.stopped_by);
  let one (o : Verdict.outcome) =
    match Scc_estimate.Cure.of_outcome model ~parameter:None ~from o with
    | None -> ()
    | Some _ ->
      incr cures;
      is "a sample where size ended it" (List.exists of_size (Verdict.truncated o.verdict));
      is "a sample of what asks for a number" (Result.is_ok (Scc_estimate.Path.of_check ~from model o.check))
  in
  List.iter one r.outcomes

(* Of one model the open check alone, that which is decided alone, and both. *)
let of_model (text, first, second) () =
  let check i formula = Printf.sprintf "check c%d : %s\n" i formula in
  let asked = [ ("open", check 1 first); ("decided", check 2 second); ("both", check 1 first ^ check 2 second) ] in
  let one (name, options) =
    List.iter
      (fun (which, checks) ->
         let model, report = run options (text ^ checks) in
         judge (Printf.sprintf "%s, %s" name which) model report)
      asked
  in
  List.iter one options

let enough () =
  Printf.printf "%d reports with causes, %d without, %d cures\n" !advised !silent !cures;
  Alcotest.(check bool) "there are both" true (!advised >= 60 && !silent >= 60 && !cures >= 60)

(* Decided at the bound, not before it: what would close it is of no interest. *)
let at_the_bound () =
  let options = { Setup.default with bounds = { bounds with states = Given 101 } } in
  let told text = (snd (run options (walls ^ text))).stats in
  let open_ = told "check c : EF AG y(q) > 1000000\n" in
  let decided = told "check c : EF (y(q) > 90 and EF vx(p) = 1)\n" in
  Alcotest.(check (list int)) "bounds" [ 1; 1 ] [ List.length open_.stopped_by; List.length decided.stopped_by ];
  Alcotest.(check (list int)) "causes" [ 1; 0 ] [ List.length open_.causes; List.length decided.causes ]

let cures_of_checks () =
  let options = { Setup.default with bounds = { bounds with states = Given 50 } } in
  let asked ?(model = drawn) formula =
    let (model, from), r = run options (model ^ "check c : " ^ formula ^ "\n") in
    List.map (fun o -> Scc_estimate.Cure.of_outcome model ~parameter:None ~from o) r.outcomes
  in
  let runs what = "`scc estimate --check c` tells " ^ what ^ " with a confidence" in
  let interval = runs "it from many runs, by an interval" in
  let endless = ", if most of them come to where it is known" in
  let expect ?model what expected formula =
    Alcotest.(check (list (option string))) what [ expected ] (asked ?model formula)
  in
  expect "a probability" (Some interval) "P = ? [ eventually x(w) > 60 within 400 ]";
  expect "one without a horizon" (Some (interval ^ endless)) "P = ? [ eventually x(w) > 60 ]";
  expect "one that is compared" (Some interval) "P >= 1/2 [ eventually x(w) > 60 within 400 ]";
  expect "one that is compared with 1" None "P >= 1 [ eventually abs(x(w)) > 60 ]";
  expect "one that is compared with 0" None "P > 0 [ eventually abs(x(w)) > 600 ]";
  expect "one that is known" None "P = ? [ eventually x(w) = 1 within 1 ]";
  expect "one about other runs" None "P = ? [ eventually (EG x(w) > 60) within 400 ]";
  expect "a mean in a range" (Some interval) "E = ? [ if x(w) > 0 then 1 else 0 at 200 ]";
  expect "a mean of a place" (Some interval) "E = ? [ x(w) at 200 ]";
  expect "a mean in none" (Some Scc_estimate.Cure.within_bounds) "E = ? [ 1/(x(w) - 1/2) at 200 ]";
  expect "a mean of times" (Some (runs "from many runs what it is at least," ^ endless))
    "E = ? [ time U x(w) > 60 ]";
  expect "a mean with a greatest value" ~model:by_place
    (Some (runs "from many runs what it is at most,"))
    "E = ? [ 2 - speed2(w) at 200 ]";
  expect "no chance" None "EF AG x(w) > 60"

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ( "advice",
    [
      ("bounds", List.mapi (fun i m -> case (string_of_int i) (of_model m)) models @ [ case "enough" enough ]);
      ("by hand", [ case "at the bound" at_the_bound; case "samples" cures_of_checks ]);
    ] )
