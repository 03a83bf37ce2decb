(* Runs that cannot be rebuilt: the rules of these models see collisions while they are explored, and none when
   runs are followed. Verdicts and all other checks stay, and what was lost is told. *)

open Scc_semantics
open Scc_state_space
open Scc_verify
open Scc_test_models
open Scc_zones

let everyone = Kinematics.everyone
let bounds = { Bounds.default with time = Given (Scc_exact.Rat.of_int 10) }
let within = { Setup.default with bounds }

(* Neighbours that are found as long as it is so. *)
let neighbours honest : Kinematics.neighbours =
  {
    within = (fun d parts -> if honest parts then everyone.within d parts else []);
    along = (fun d parts -> if honest parts then everyone.along d parts else []);
    earliest =
      (fun ~margin ~limit time parts ->
         if honest parts then everyone.earliest ~margin ~limit time parts else None);
  }

let model ~honest text =
  let e = Load.exactly (Load.text text) in
  (e, Semantics.make ~neighbours:(neighbours honest) e.model)

let run ?(options = within) (e : Scc_elaborate.Elaborate.t) semantics =
  match Network.initial semantics e.declared with
  | Ok initial -> Check.run options semantics ~initial e.checks
  | Error _ -> Alcotest.fail "no initial state"

(* Until the exploration is over. *)
let while_exploring ?(options = within) text =
  let exploring = ref true in
  let over () = exploring := false in
  let expanding ~about:_ t ~all_edges ~waits ~room ~dull =
    exploring := true;
    let e = State_graph.here t ~all_edges ~waits ~room ~dull in
    { e with finish = (fun () -> over (e.finish ())) }
  in
  let compacting ~about:_ context =
    exploring := true;
    let e = State_fingerprints.here context in
    { e with finish = (fun () -> over (e.finish ())) }
  in
  let e, semantics = model ~honest:(fun _ -> !exploring) text in
  run ~options:{ options with expanding; compacting } e semantics

let told (o : Verdict.outcome) =
  let shown = if Option.is_some (Verdict.shown o.verdict) then "shown" else "not shown" in
  let lost = if o.lost = [] then "" else ", lost" in
  Printf.sprintf "%s: %s, %s%s" o.check.name (Verdict.to_string o.verdict) shown lost

let expect what expected outcomes = Alcotest.(check (list string)) what expected (List.map told outcomes)

let meeting =
  {|
shape C = box(1,1,1)
process p = C mass 1 velocity (1,0,0) [nil]
process q = C mass 1 at translate (4,0,0) [nil]
|}

let checks =
  {|
check met   : possibly event bounce(p)
check stays : always vx(p) = 1
check now   : possibly x(p) = 0
check never : always x(p) < 100
check both  : (possibly event bounce(p)) and (always vx(p) = 1)
check nest  : EF (vx(p) = 0 and EG vx(q) = 1)
check whole : AG x(q) >= 4
|}

let of_states =
  [
    "met: holds (exhaustive), not shown, lost";
    "stays: violated, not shown, lost";
    "now: holds (exhaustive), shown";
    "never: holds (exhaustive), not shown";
    "both: violated, not shown, lost";
    "nest: holds (exhaustive), not shown, lost";
    "whole: holds (exhaustive), not shown";
  ]

let states () =
  let report = while_exploring (meeting ^ checks) in
  expect "ordinary states" of_states report.outcomes;
  Alcotest.(check int) "told once" 1 (List.length (Check.faults report));
  let o = List.hd report.outcomes in
  Alcotest.(check string) "in words"
    "holds (exhaustive); its run could not be rebuilt: this is a fault of scc" (Verdict.outcome_to_string o);
  Alcotest.(check (list string)) "nothing is said of dead ends" []
    (List.concat_map (fun (o : Verdict.outcome) -> List.map Verdict.rest_to_string o.rests) report.outcomes)

let without_faults () =
  let e, semantics = model ~honest:(fun _ -> true) (meeting ^ checks) in
  let report = run e semantics in
  Alcotest.(check (list string)) "none" [] (Check.faults report);
  Alcotest.(check (list bool)) "all runs that there are" [ true; true; true; false; true; true; false ]
    (List.map (fun (o : Verdict.outcome) -> Option.is_some (Verdict.shown o.verdict)) report.outcomes)

let chances () =
  let text =
    "timestep 1 steady\n" ^ meeting
    ^ {|
motion p = choose { (1,0,0) weight 1, (2,0,0) weight 1 }
check likely : P >= 1/2 [ eventually event bounce(p) ]
check number : P = ? [ eventually event bounce(p) ]
check mean   : E = ? [ time U vx(q) > 0 ]
check start  : possibly x(p) = 0
|}
  in
  let report = while_exploring text in
  Alcotest.(check (list bool)) "those with a run" [ true; true; false; false ]
    (List.map (fun (o : Verdict.outcome) -> o.lost <> []) report.outcomes)

let unexplored () =
  let text =
    {|
behaviour K on C = eps(1). K
process r = C mass 1 velocity (0,1,0) at translate (0,9,0) [K]
check later : possibly (x(q) > 50 and x(r) = 0)
check far   : possibly x(q) > 50
check start : possibly x(p) = 0
|}
  in
  let options = { within with bounds = { bounds with depth = Given 7 } } in
  let report = while_exploring ~options (meeting ^ text) in
  Alcotest.(check (list bool)) "the way to what was not explored" [ true; true; false ]
    (List.map (fun (o : Verdict.outcome) -> o.lost <> []) report.outcomes)

let compacted () =
  let report =
    while_exploring ~options:{ Setup.default with compact = Some 1000 }
      (meeting ^ "check met : possibly event bounce(p)\ncheck never : always x(p) < 100\n")
  in
  Alcotest.(check (list bool)) "with hash compaction" [ true; false ]
    (List.map (fun (o : Verdict.outcome) -> o.lost <> []) report.outcomes)

(* When a run of a slice is made one of the whole network, events are foreseen by asking for contacts one by
   one. *)
let slices () =
  let text =
    meeting
    ^ {|
process far = C mass 1 at translate (0,90,0) [nil]
check met   : possibly event bounce(p) within 9
check start : possibly (x(far) = 0 and y(far) = 90)
|}
  in
  let e = Load.exactly (Load.text text) in
  let over = ref false and among_all = ref false in
  let exact = Geometry.exact ~obstacle:Scc_geometry.Obstacle.make in
  let first_time_of_contact a b w =
    if !over && not !among_all then Scc_base.Bug.fail __POS__ "foreseen"
    else exact.first_time_of_contact a b w
  in
  let neighbours =
    {
      everyone with
      earliest =
        (fun ~margin ~limit time parts ->
           among_all := true;
           let t = everyone.earliest ~margin ~limit time parts in
           among_all := false;
           t);
    }
  in
  let semantics = Semantics.make ~geometry:{ exact with first_time_of_contact } ~neighbours e.model in
  let expanding ~about:_ t ~all_edges ~waits ~room ~dull =
    let e = State_graph.here t ~all_edges ~waits ~room ~dull in
    let expand i tuple =
      over := false;
      e.expand i tuple
    and finish () =
      e.finish ();
      over := true
    in
    { e with expand; finish }
  in
  let report = run ~options:{ Setup.default with expanding } e semantics in
  Alcotest.(check bool) "there are slices" true (report.slices <> []);
  expect "runs of slices"
    [ "met: holds (exhaustive), not shown, lost"; "start: holds (exhaustive), shown" ]
    report.outcomes

(* Sets of states are not asked when two bodies meet; a run through the rules is. *)
let zones () =
  let text =
    {|
shape C = box(1,1,1)
param d in [4, 5]
process p = C mass 1 velocity (1,0,0) [nil]
process q = C mass 1 at translate (d,0,0) [nil]
check met   : possibly event bounce(p)
check stays : always vx(p) = 1
check nest  : E[ vx(p) = 1 U vx(q) = 1 ]
check never : always x(p) < 100
|}
  in
  let e = Load.exactly (Load.text text) in
  let exact = Geometry.exact ~obstacle:Scc_geometry.Obstacle.make in
  let first_time_of_contact _ _ _ = Scc_base.Bug.fail __POS__ "asked" in
  let semantics = Semantics.make ~geometry:{ exact with first_time_of_contact } e.model in
  let u = Option.get e.uncertain in
  match Zone_check.run within semantics u ~declared:e.declared ~exactly:false ~premises:[] e.checks with
  | Error _ -> Alcotest.fail "the start is not well-formed"
  | Ok report ->
    Alcotest.(check (list bool)) "those with a run" [ true; true; true; false ]
      (List.map (fun (o : Verdict.outcome) -> o.lost <> []) report.outcomes)

(* What ends a run for another reason is no fault. *)
exception Limit

let others () =
  let lost = Lost.make Bounds.default Scc_graph_search.Limits.quiet.attempt in
  let e, semantics = model ~honest:(fun _ -> true) meeting in
  ignore e;
  let attempt f = Lost.run lost semantics f in
  let raises e = match attempt (fun () -> raise e) with _ -> false | exception found -> found == e in
  Alcotest.(check bool) "a limit passes" true (raises Limit && raises Out_of_memory);
  Alcotest.(check (list string)) "and is no fault" [] (Lost.taken lost).faults;
  let broken () = Scc_base.Bug.fail ("here", 1, 2, 3) "broken" in
  Alcotest.(check bool) "no run" true (Option.is_none (attempt broken) && Option.is_none (attempt broken));
  let taken () = (Lost.taken lost).faults in
  Alcotest.(check (list string)) "kept once" [ "Bug at here:1: broken" ] (taken ());
  Alcotest.(check (list string)) "and taken" [] (taken ());
  let fault what = ignore (attempt (fun () -> Scc_base.Bug.fail ("here", 1, 2, 3) what)) in
  List.iter fault [ "one"; "two"; "one" ];
  Alcotest.(check (list string)) "in order" [ "Bug at here:1: one"; "Bug at here:1: two" ] (taken ())

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ( "lost runs",
    [
      ( "rebuilt",
        [
          case "no fault" without_faults;
          case "ordinary states" states;
          case "probabilities" chances;
          case "the way to what was not explored" unexplored;
          case "hash compaction" compacted;
          case "slices" slices;
          case "zones" zones;
          case "what is no fault" others;
        ] );
    ] )
