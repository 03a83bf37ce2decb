(* Conclusions that are given up, each of them: what is known stays, and what is missing is told. No clock has a
   part in it: it is the number of a conclusion that ends it. *)

open Scc_graph_search
open Scc_semantics
open Scc_verify
open Scc_test_models
open Scc_zones

(* Which conclusions are given up, by their numbers. *)
type way =
  | Alone of int
  | From of int
  | Done of int  (** from this one on, when it has done its work *)

let given_up way number =
  match way with Alone n -> number = n | From n | Done n -> number >= n

let surroundings way number =
  let run (type a) (stage : Limits.stage) (f : unit -> a) : (a, Limits.stop) result =
    match stage with
    | Exploring | Proving | Reporting -> Ok (f ())
    | Concluding -> (
        let this = !number in
        incr number;
        match (given_up way this, way) with
        | false, _ -> Ok (f ())
        | true, (Alone _ | From _) -> Error Interrupted
        | true, Done _ ->
          ignore (f ());
          Error Interrupted)
  in
  Limits.undivided ~attempt:{ run } ()

let walls =
  {|
shape C = box(1,1,1)
process p = C mass 1 velocity (1,0,0) [nil]
fixed w1 = C at translate (-2,0,0)
fixed w2 = C at translate (2,0,0)
process q = C mass 1 velocity (0,1,0) at translate (0,9,0) [nil]
|}

let checks =
  {|
check met    : possibly event bounce(p)
check stays  : always vx(p) = 1
check never  : possibly y(q) < 9
check far    : possibly y(q) > 1000000
check near   : always y(q) < 1000000
check both   : (possibly event bounce(p)) and (always y(q) < 1000000)
check nest   : EF (vx(p) = -1 and EF vx(p) = 1)
check bars   : AG (vx(p) = 1)
check open   : EF AG y(q) > 1000000
check passes : A[ y(q) >= 9 U time >= 3 ]
|}

let drawn =
  {|
timestep 1 steady
shape C = box(1,1,1)
process p = C mass 1 velocity (1,0,0) [nil]
process q = C mass 1 at translate (4,0,0) [nil]
motion p = choose { (1,0,0) weight 1, (0,0,0) weight 1 }
check likely : P >= 1/8 [ eventually event bounce(p) ]
check never  : P >= 1 [ eventually x(p) > 100 ]
check number : P = ? [ eventually event bounce(p) ]
check mean   : E = ? [ time U event bounce(p) ]
check above  : E >= 100 [ time U event bounce(p) ]
|}

let ranged =
  {|
param d in [4, 5]
shape C = box(1,1,1)
process p = C mass 1 velocity (1,0,0) [nil]
process q = C mass 1 at translate (d,0,0) [nil]
check met   : possibly event bounce(p)
check stays : always vx(p) = 1
check nest  : E[ vx(p) = 1 U vx(q) = 1 ]
check early : A[ x(p) < 1 U time >= 1 ]
check far   : possibly x(q) > 100
|}

let depth n = { Setup.default with bounds = { Bounds.default with depth = Given n } }
let states n = { Setup.default with bounds = { Bounds.default with states = Given n } }

let ordinary (options : Setup.t) (e : Scc_elaborate.Elaborate.t) =
  let semantics = Scc_engine.Standard.of_model e.model in
  match Network.initial semantics e.declared with
  | Ok initial -> Check.run options semantics ~initial e.checks
  | Error _ -> Alcotest.fail "no initial state"

let zones (options : Setup.t) (e : Scc_elaborate.Elaborate.t) =
  let semantics = Scc_engine.Standard.of_model e.model in
  let u = Option.get e.uncertain in
  match Zone_check.run options semantics u ~declared:e.declared ~exactly:false ~premises:[] e.checks with
  | Ok report -> report
  | Error _ -> Alcotest.fail "the start is not well-formed"

let cases =
  [
    ("searches and formulas", ordinary, depth 20, walls ^ checks, 19);
    ("without slices", ordinary, { (depth 20) with reductions = [] }, walls ^ checks, 19);
    ("likely causes", ordinary, states 200, walls ^ checks, 19);
    ("hash compaction", ordinary, { (depth 20) with compact = Some 100 }, walls ^ checks, 15);
    ("probabilities", ordinary, depth 8, drawn, 13);
    ("zones", zones, Setup.default, ranged, 7);
    ("zones within a bound", zones, depth 1, ranged, 8);
    ("Zeno behaviour", ordinary, Setup.default, "slot.sc", 14);
  ]

let models = "../../../specs/models/"
let words (o : Verdict.outcome) = Verdict.to_string o.verdict
let is_shown (o : Verdict.outcome) = Option.is_some (Verdict.shown o.verdict)

let unevaluated (o : Verdict.outcome) =
  match o.verdict with
  | Undecided reasons | Measured { reasons; _ } ->
    List.exists (function Verdict.Unevaluated _ -> true | _ -> false) reasons
  | Holds _ | Violated _ | Depends _ -> false

(* Without the run to what was not explored, and what is told of how many states matter. *)
let without_run (o : Verdict.outcome) =
  let stays = function Verdict.Unexplored _ -> false | _ -> true in
  match o.verdict with
  | Undecided reasons -> Verdict.to_string (Undecided (List.filter stays reasons))
  | Measured m -> Verdict.to_string (Measured { m with reasons = List.filter stays m.reasons })
  | Holds _ | Violated _ | Depends _ -> words o

let same_outcome what (whole : Verdict.outcome) (o : Verdict.outcome) =
  let what = Printf.sprintf "%s, %s: %s" what o.check.name (Verdict.outcome_to_string o) in
  let is = Alcotest.(check bool) in
  if not (unevaluated o) then Alcotest.(check string) what (without_run whole) (without_run o);
  is (what ^ ": shown, or told") true
    (Bool.equal (is_shown whole) (is_shown o) || Option.is_some o.left_out || unevaluated o);
  is (what ^ ": nothing is told where nothing is missing") false
    (is_shown o && Option.is_some o.left_out);
  is (what ^ ": the interruption is named") true
    (match o.left_out with None | Some { limit = Interrupted; _ } -> true | Some _ -> false)

let kinds (s : Stats.t) = List.map Growth.kind s.causes

let same_report what (whole : Check.report) (r : Check.report) =
  List.iter2 (same_outcome what) whole.outcomes r.outcomes;
  let missing = List.filter (fun k -> not (List.mem k (kinds r.stats))) (kinds whole.stats) in
  Alcotest.(check bool) (what ^ ": causes, or told") true (missing = [] || Option.is_some r.stats.left_out);
  Alcotest.(check bool) (what ^ ": Zeno behaviour, or told") true
    (Bool.equal (Option.is_some whole.zeno) (Option.is_some r.zeno) || Option.is_some r.left_out);
  Alcotest.(check (list string)) (what ^ ": no faults") [] (Check.faults r)

(* The truth of a formula and a run that shows it are conclusions apart, so that there are at least so many. *)
let of_case (name, run, options, text, least) () =
  let is_file = Filename.check_suffix text ".sc" in
  let model = Load.exactly (if is_file then Load.file (models ^ text) else Load.text text) in
  let report way =
    let number = ref 0 in
    let r : Check.report = run { options with Setup.surroundings = surroundings way number } model in
    (r, !number)
  in
  let whole, conclusions = report (Alone (-1)) in
  Alcotest.(check bool) (Printf.sprintf "%s: %d conclusions" name conclusions) true (conclusions >= least);
  Alcotest.(check bool) "all is shown" true
    (List.for_all (fun (o : Verdict.outcome) -> Option.is_none o.left_out) whole.outcomes);
  Alcotest.(check bool) "Zeno behaviour" (String.equal name "Zeno behaviour") (Option.is_some whole.zeno);
  let each n =
    List.iter
      (fun (way, told) -> same_report (Printf.sprintf "%s, %s %d" name told n) whole (fst (report way)))
      [ (Alone n, "alone"); (From n, "from"); (Done n, "done, from") ]
  in
  List.iter each (List.init conclusions Fun.id)

let suite =
  let case ((name, _, _, _, _) as c) = Alcotest.test_case name `Quick (of_case c) in
  ("conclusions that are given up", [ ("each", List.map case cases) ])
