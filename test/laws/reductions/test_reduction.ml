(* Each way to explore less against exploring everything: the same verdicts on random crowds of equal bodies,
   witnesses that replay by the rules, and no more states. *)

open Scc_ctl
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_evaluate
open Scc_space
open Scc_explain
open Scc_verify

let standard = Scc_engine.Standard.of_model

open Crowds

(* {1 The comparison} *)

let load text =
  match Scc_test_models.Load.text text with
  | Error _ -> None  (* where all are shy, no formula may speak of docking *)
  | Ok e -> Result.to_option (Result.map (fun s -> (e, s)) (Network.initial (standard e.model) e.declared))

let bounds = { Bounds.default with states = Default 3000; time = Given (Rat.of_int 12); instant = Default 60 }

let run ?(bounds = bounds) reductions (e : Scc_elaborate.Elaborate.t) initial =
  Check.run { Check.default with bounds; reductions } (standard e.model) ~initial e.checks

let definite (v : Verdict.t) =
  match v with
  | Holds { bounds = []; _ } -> Some true
  | Violated _ -> Some false
  | Holds _ | Measured _ | Undecided _ -> None

let conflict (a : Verdict.outcome) (b : Verdict.outcome) =
  match (a.verdict, b.verdict) with
  | Measured x, Measured y -> x.reasons = [] && y.reasons = [] && x.values <> y.values
  | v, w -> (
      match (definite v, definite w) with
      | Some x, Some y -> not (Bool.equal x y)
      | None, _ | _, None -> false)

let witness : Verdict.t -> Witness.t option = function
  | Holds { witness; _ } | Violated { witness } | Measured { witness; _ } -> witness
  | Undecided _ -> None

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
    let wanted = match v with Holds _ -> Truth.True | Violated _ | Measured _ | Undecided _ -> False in
    Truth.equal holds wanted
  | _ -> true

(* The bound of time cuts both alike. *)
let comparable (s : Check.stats) =
  (not s.decided_early)
  && List.for_all
    (fun (t : Verdict.truncation) -> match t.limit with Time _ -> true | _ -> false)
    s.stopped_by

let decided = ref 0
let refused = ref 0

(* Several explorations may have more states than one: [together] is false. *)
let agrees kinds ~jump ~together text =
  match load text with
  | None -> incr refused; true
  | Some (e, initial) ->
    let full = run [ Reduction.Jump ] e initial in
    let reduced = run kinds e initial in
    let count (o : Verdict.outcome) = if Option.is_some (definite o.verdict) then incr decided in
    List.iter count full.outcomes;
    let comparable = comparable full.stats && comparable reduced.stats in
    if List.exists2 conflict full.outcomes reduced.outcomes then QCheck2.Test.fail_report "verdicts differ"
    else if jump && not (List.for_all (replays e initial) reduced.outcomes) then
      QCheck2.Test.fail_report "a witness does not replay"
    else if not (List.for_all (shows e) reduced.outcomes) then
      QCheck2.Test.fail_report "a witness does not show what it should"
    else if jump && together && comparable && reduced.slices = [] && reduced.stats.states > full.stats.states then
      QCheck2.Test.fail_report "more states than without"
    else true

let property ?(jump = true) ?(count = 110) name kinds =
  QCheck2.Test.make ~name ~count ~print:Fun.id case_gen (agrees kinds ~jump ~together:true)

let timed name kinds =
  QCheck2.Test.make ~name ~count:125 ~print:Fun.id timed_case_gen (agrees kinds ~jump:true ~together:false)

(* With collisions together, with binding by contact, or both, and with steps of single processes. *)
let with_switches text =
  let own_steps line = if String.equal line "timestep 1" then "timestep 1 local" else line in
  let text = String.concat "\n" (List.map own_steps (String.split_on_char '\n' text)) in
  let settings = [ "collisions together"; "binding contact"; "collisions together\nbinding contact" ] in
  QCheck2.Gen.map (fun s -> text ^ "\n" ^ s ^ "\n") (QCheck2.Gen.oneofl settings)

let switched name kinds =
  QCheck2.Test.make ~name ~count:50 ~print:Fun.id
    QCheck2.Gen.(case_gen >>= with_switches)
    (agrees kinds ~jump:true ~together:true)

let closings = ref 0

let counts_closings text =
  let counted =
    match load text with
    | None -> []
    | Some (e, initial) -> Scc_test_networks.Reach.states e.model initial ~limit:40
  in
  let closes (t : Transition.t) = match t.label with Close _ -> true | _ -> false in
  closings := !closings + List.length (List.filter closes (List.concat_map snd counted));
  true

let ringed name kinds =
  QCheck2.Test.make ~name ~count:60 ~print:Fun.id ringed_case_gen (fun text ->
      counts_closings text && agrees kinds ~jump:true ~together:true text)

(* {1 Each does something} *)

let states reductions text =
  match load text with
  | None -> Alcotest.fail "the model is refused"
  | Some (e, initial) ->
    let report = Check.run { Check.default with reductions } (standard e.model) ~initial e.checks in
    let stats = report.stats in
    Alcotest.(check bool) "complete" true stats.complete;
    stats.states

let fewer kind text ~with_it ~without () =
  Alcotest.(check int) "without" without (states [ Reduction.Jump ] text);
  Alcotest.(check int) "with" with_it (states [ kind; Reduction.Jump ] text)

(* Four pairs collide at one instant, and nobody asks: in one order, or in each of the 2^4 sets that may have
   done so. *)
let four_pairs =
  shapes
  ^ {|
for i in 1..4 {
  process p[i] = Cube mass 1 velocity (1,0,0) at translate (0,4*i,0) [Shy]
  process q[i] = Cube mass 1 velocity (-1,0,0) at translate (8,4*i,0) [Shy]
}
process r = Cube mass 1 velocity (0,0,1) at translate (40,0,0) [Shy]
check far : possibly x(r) > 41
|}

(* The first of three pairs has collided, and the third, which nobody asks about, after it, so that the first has
   not just done so: this is in one of the orders only. *)
let hides_no_event () =
  let text =
    shapes
    ^ {|
for i in 1..3 {
  process p[i] = Cube mass 1 velocity (1,0,0) at translate (0,4*i,0) [Shy]
  process q[i] = Cube mass 1 velocity (-1,0,0) at translate (8,4*i,0) [Shy]
}
check seen : possibly (not event bounce(p[1], q[1])) and vx(p[1]) < 0 and vx(p[2]) > 0
|}
  in
  match load text with
  | None -> Alcotest.fail "the model is refused"
  | Some (e, initial) ->
    let verdict reductions =
      match (run reductions e initial).outcomes with [ o ] -> definite o.verdict | _ -> None
    in
    Alcotest.(check (option bool)) "all orders" (Some true) (verdict [ Jump ]);
    Alcotest.(check (option bool)) "with order" (Some true) (verdict [ Order; Jump ])

(* Two equal balls go round a square, opposite to each other: after half a round they have changed places. *)
let two_balls =
  shapes
  ^ {|
fixed west  = Cube scaled (1,5,1) at translate (-7,0,0)
fixed east  = Cube scaled (1,5,1) at translate (7,0,0)
fixed south = Cube scaled (5,1,1) at translate (0,-7,0)
fixed north = Cube scaled (5,1,1) at translate (0,7,0)
process p = Cube mass 1 velocity (1,-1,0) at translate (-1,-4,0) [Shy]
process q = Cube mass 1 velocity (-1,1,0) at translate (1,4,0) [Shy]
check calm : always energy = 2
|}

(* A pair that drifts, and may come apart at any split instant, or not. *)
let drifting =
  shapes
  ^ {|
process d = p : Cube mass 1 velocity (1,0,0) at translate (0,0,0) [Held] <dock, {p.right, q.left}>
            q : Cube mass 1 velocity (1,0,0) at translate (2,0,0) [Held]
check held : possibly bonds(dock) = 0
check same : eventually bonds(dock) = 0
|}

(* Two pairs collide at one instant: between their bounces either may be first, which is seen by who names both. *)
let seen () =
  let text =
    shapes
    ^ {|
for i in 1..2 {
  process p[i] = Cube mass 1 velocity (1,0,0) at translate (0,4*i,0) [Shy]
  process q[i] = Cube mass 1 velocity (-1,0,0) at translate (8,4*i,0) [Shy]
}
check first  : possibly vx(p[1]) < 0 and vx(p[2]) > 0
check second : possibly vx(p[1]) > 0 and vx(p[2]) < 0
|}
  in
  match load text with
  | None -> Alcotest.fail "the model is refused"
  | Some (e, initial) ->
    let report = run ~bounds:Bounds.default [ Order; Jump ] e initial in
    let verdicts = List.map (fun (o : Verdict.outcome) -> Verdict.to_string o.verdict) report.outcomes in
    Alcotest.(check (list string)) "both" [ "holds (exhaustive)"; "holds (exhaustive)" ] verdicts

(* A plate bounces for ever within the first instant, unseen; what others do then is not put off for ever. *)
let not_put_off () =
  let text =
    shapes
    ^ {|
fixed floor   = Cube at translate (0,-2,0)
fixed ceiling = Cube at translate (0,2,0)
process plate = Cube mass 1 velocity (0,1,0) [Shy]
process p = Cube mass 1 velocity (1,0,0)  at translate (40,0,0) [Shy]
process q = Cube mass 1 velocity (-1,0,0) at translate (42,0,0) [Shy]
check away : possibly vx(q) = 1
|}
  in
  match load text with
  | None -> Alcotest.fail "the model is refused"
  | Some (e, initial) ->
    let report = run ~bounds:Bounds.default [ Order; Jump ] e initial in
    let verdicts = List.map (fun (o : Verdict.outcome) -> Verdict.to_string o.verdict) report.outcomes in
    Alcotest.(check (list string)) "reached" [ "holds (exhaustive)" ] verdicts

let drift () =
  Alcotest.(check int) "with" 2 (states [ Reduction.Translation; Jump ] drifting)

let verdicts_and_stats reductions text =
  match load text with
  | None -> Alcotest.fail "the model is refused"
  | Some (e, initial) ->
    let bounds = { Bounds.default with states = Default 3000 } in
    let report = Check.run { Check.default with bounds; reductions } (standard e.model) ~initial e.checks in
    (List.map (fun (o : Verdict.outcome) -> Verdict.to_string o.verdict) report.outcomes, report.stats)

(* Alone it is violated in two states, and it stays so whatever else is asked. *)
let unspoilt () =
  let text = drifting ^ "check slow : always time * time >= 0\n" in
  let verdicts, _ = verdicts_and_stats Reduction.all text in
  let limited = "holds up to the bound: the bound of 3000 states (a default)" in
  Alcotest.(check (list string)) "time is kept for one" [ "holds (exhaustive)"; "violated"; limited ] verdicts;
  let verdicts, _ = verdicts_and_stats [ Reduction.Translation; Jump ] text in
  Alcotest.(check bool) "time is kept for all" false (List.nth verdicts 1 = "violated")

let up_to_a_constant () =
  let text =
    two_balls
    ^ {|
check late   : AG (time > 20 => AF touching(p, east))
check early  : possibly time <= 11 and 2 * time > 15 and touching(p, north)
check passes : eventually time = 30
check after  : EF (time > 30 and EG (not touching(p, east)))
|}
  in
  let verdicts, stats = verdicts_and_stats [ Reduction.Time; Jump ] text in
  let holds = "holds (exhaustive)" in
  Alcotest.(check (list string)) "proofs" [ holds; holds; holds; holds; "violated" ] verdicts;
  Alcotest.(check bool) "all is explored" true stats.complete

(* The first of two equal balls is absorbed: the other one takes its name, and a witness finds its way back. *)
let gone () =
  let text =
    shapes
    ^ {|
fixed out = Cube scaled (1,9,9) absorb at translate (-9,0,0)
process p = Cube mass 1 velocity (-1,0,0) at translate (0,0,0) [Shy]
process q = Cube mass 1 velocity (-1,0,0) at translate (4,0,0) [Shy]
check two  : always processes >= 2
check none : eventually processes = 1
|}
  in
  List.iter
    (fun reductions ->
       match load text with
       | None -> Alcotest.fail "the model is refused"
       | Some (e, initial) ->
         let report = run reductions e initial in
         let verdicts = List.map (fun (o : Verdict.outcome) -> Verdict.outcome_to_string o) report.outcomes in
         Alcotest.(check (list string)) "verdicts" [ "violated"; "holds (exhaustive)" ] verdicts)
    Reduction.[ [ Symmetry; Jump ]; [ Jump ] ]

(* Each of two equal balls comes to the wall in the east and to that in the west, but in half a round, after which
   they have changed places, only one of them to each: that is one state for both searches. *)
let several () =
  let text =
    two_balls
    ^ {|
check both  : (possibly touching(p, east)) and (possibly touching(q, east))
check one   : (always not touching(p, east)) or (always not touching(q, east))
|}
  in
  let is reductions =
    let verdicts, _ = verdicts_and_stats reductions text in
    let last_two = List.filteri (fun i _ -> i >= List.length verdicts - 2) verdicts in
    Alcotest.(check (list string)) "verdicts" [ "holds (exhaustive)"; "violated" ] last_two
  in
  List.iter is Reduction.[ [ Jump ]; [ Symmetry; Jump ]; all ]

let enough () =
  Alcotest.(check bool) "few models are refused" true (!refused < 100);
  Alcotest.(check bool) "most formulas are decided" true (!decided > 700);
  Alcotest.(check bool) "rings close" true (!closings > 60)

let () =
  let with_jump kind = [ kind; Reduction.Jump ] in
  let quick name f = Alcotest.test_case name `Quick f in
  Alcotest.run "reduction"
    [
      ( "random crowds",
        Scc_test_support.Property.cases
          [
            property "Fragments: symmetry" (with_jump Symmetry);
            property "Fragments: translation" (with_jump Translation);
            property "Fragments: order" (with_jump Order);
            property "Fragments: slice" (with_jump Slice);
            property "Fragments: all" Reduction.all;
            timed "Fragments: time" (with_jump Time);
            timed "Fragments: time, and all else" Reduction.all;
            property "Fragments: no jumps" ~jump:false [];
            switched "Fragments: symmetry and translation, with the switches of a model"
              Reduction.[ Symmetry; Translation; Jump ];
            switched "Fragments: all, with the switches of a model" Reduction.all;
            ringed "Fragments: symmetry and translation, with bonds that close rings"
              Reduction.[ Symmetry; Translation; Jump ];
            ringed "Fragments: order and slice, with bonds that close rings" Reduction.[ Order; Slice; Jump ];
          ] );
      ( "effects",
        [
          quick "enough is decided" enough;
          quick "order" (fewer Order four_pairs ~with_it:6 ~without:17);
          quick "order hides no event" hides_no_event;
          quick "symmetry" (fewer Symmetry two_balls ~with_it:9 ~without:17);
          quick "symmetry, where one is gone" gone;
          quick "symmetry, of several searches" several;
          quick "translation" drift;
          quick "time spoils no other property" unspoilt;
          quick "time counts up to a constant" up_to_a_constant;
          quick "what is seen happens in every order" seen;
          quick "nothing is put off for ever" not_put_off;
        ] );
    ]
