(* Checks explored with and without some ways to explore less: the same verdicts, witnesses that replay by the
   rules, and no more states. *)

open Scc_ctl
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_evaluate
open Scc_state_space
open Scc_explain
open Scc_verify

let standard = Scc_engine.Standard.of_model

(* {1 The comparison} *)

let load text =
  match Scc_test_models.Load.text text with
  | Error _ -> None  (* where all are shy, no formula may speak of docking *)
  | Ok e -> Result.to_option (Result.map (fun s -> (e, s)) (Network.initial (standard e.model) e.declared))

let bounds = { Bounds.default with states = Default 3000; time = Given (Rat.of_int 12); instant = Default 60 }

let run ?(bounds = bounds) reductions (e : Scc_elaborate.Elaborate.t) initial =
  Check.run { Setup.default with bounds; reductions } (standard e.model) ~initial e.checks

let definite (v : Verdict.t) =
  match v with
  | Holds { bounds = []; _ } -> Some true
  | Violated _ -> Some false
  | Holds _ | Measured _ | Depends _ | Undecided _ -> None

let conflict (a : Verdict.outcome) (b : Verdict.outcome) =
  match (a.verdict, b.verdict) with
  | Measured x, Measured y -> x.reasons = [] && y.reasons = [] && x.values <> y.values
  | v, w -> (
      match (definite v, definite w) with
      | Some x, Some y -> not (Bool.equal x y)
      | None, _ | _, None -> false)

let witness : Verdict.t -> Witness.t option = function
  | Holds { witness; _ } | Violated { witness } | Measured { witness; _ } -> witness
  | Depends _ | Undecided _ -> None

(* By the rules alone, in the model as it is. *)
let replays (e : Scc_elaborate.Elaborate.t) initial (o : Verdict.outcome) =
  match witness o.verdict with
  | None -> true
  | Some w -> (
      match Scc_test_networks.Reach.follow (standard e.model) initial (Witness.choices w) with
      | Error _ -> false
      | Ok transitions ->
        let last = match List.rev transitions with [] -> initial | t :: _ -> t.Transition.target in
        State.equal last w.last)

(* What was searched for is so where the witness ends: whether p holds there, after its last transition. *)
let shows (e : Scc_elaborate.Elaborate.t) ({ check = c; verdict = v; _ } : Verdict.outcome) =
  match (witness v, Plan.of_formula c.formula) with
  | Some ({ finish = At_state; _ } as w), (Possibly (_, p) | Always (_, p))
    when not (Formula.has_events (State p)) ->
    let holds = Trajectory.holds (standard e.model) w.last p in
    let wanted = match v with Holds _ -> Truth.True | Violated _ | Measured _ | Depends _ | Undecided _ -> False in
    Truth.equal holds wanted
  | _ -> true

(* The bound of time cuts both alike. *)
let comparable (s : Stats.t) =
  (not s.decided_early)
  && List.for_all
    (fun (t : Verdict.truncation) -> match t.limit with Time _ -> true | _ -> false)
    s.stopped_by

(* Everything is explored once of each text: properties of one generator and seed are tried on the same ones. *)
let explored = Hashtbl.create 500

let everything text e initial =
  match Hashtbl.find_opt explored text with
  | Some report -> report
  | None ->
    let report = run [ Reduction.Jump ] e initial in
    Hashtbl.add explored text report;
    report

let decided = ref 0
let refused = ref 0

(* Several explorations may have more states than one: [together] is false. *)
let agrees kinds ~jump ~together text =
  match load text with
  | None -> incr refused; true
  | Some (e, initial) ->
    let full = everything text e initial in
    let reduced = run kinds e initial in
    let count (o : Verdict.outcome) = if Option.is_some (definite o.verdict) then incr decided in
    List.iter count full.outcomes;
    let comparable = comparable full.stats && comparable reduced.stats in
    if Check.faults reduced <> [] then QCheck2.Test.fail_report "a run is lost"
    else if List.exists2 conflict full.outcomes reduced.outcomes then QCheck2.Test.fail_report "verdicts differ"
    else if jump && not (List.for_all (replays e initial) reduced.outcomes) then
      QCheck2.Test.fail_report "a witness does not replay"
    else if not (List.for_all (shows e) reduced.outcomes) then
      QCheck2.Test.fail_report "a witness does not show what it should"
    else if jump && together && comparable && reduced.slices = [] && reduced.stats.states > full.stats.states then
      QCheck2.Test.fail_report "more states than without"
    else true

let verdicts_and_stats reductions text =
  match load text with
  | None -> Alcotest.fail "the model is refused"
  | Some (e, initial) ->
    let bounds = { Bounds.default with states = Default 3000 } in
    let report = Check.run { Setup.default with bounds; reductions } (standard e.model) ~initial e.checks in
    (List.map (fun (o : Verdict.outcome) -> Verdict.to_string o.verdict) report.outcomes, report.stats)
