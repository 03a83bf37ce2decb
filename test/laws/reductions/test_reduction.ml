(* Each way to explore less against exploring everything: the same verdicts on random crowds of equal bodies,
   witnesses that replay by the rules, and no more states. *)

open Scc_semantics
open Scc_state_space
open Scc_verify
open Crowds
open Compared

(* Checks that see places for ever have an exploration of their own where others can do without. *)
let together kinds = not (List.exists (Reduction.equal Drift) kinds)

let property ?(jump = true) ?(count = 60) name kinds =
  QCheck2.Test.make ~name ~count ~print:Fun.id case_gen (agrees kinds ~jump ~together:(together kinds))

let timed name kinds =
  QCheck2.Test.make ~name ~count:65 ~print:Fun.id timed_case_gen (agrees kinds ~jump:true ~together:false)

(* With collisions together, with binding by contact, or both, and with steps of single processes. *)
let with_switches text =
  let own_steps line = if String.equal line "timestep 1" then "timestep 1 local" else line in
  let text = String.concat "\n" (List.map own_steps (String.split_on_char '\n' text)) in
  let settings = [ "collisions together"; "binding contact"; "collisions together\nbinding contact" ] in
  QCheck2.Gen.map (fun s -> text ^ "\n" ^ s ^ "\n") (QCheck2.Gen.oneofl settings)

let switched name kinds =
  QCheck2.Test.make ~name ~count:50 ~print:Fun.id
    QCheck2.Gen.(case_gen >>= with_switches)
    (agrees kinds ~jump:true ~together:(together kinds))

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
    let report = Check.run { Setup.default with reductions } (standard e.model) ~initial e.checks in
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

(* In each of three groups two pairs collide at one instant. Within a group both orders lead to one state, from
   which the other groups go on: 3 times 3 states, instead of 2^6 sets. *)
let pairs_in_groups =
  shapes
  ^ {|
for i in 1..3 {
  for j in 0..1 {
    process p[i, j] = Cube mass 1 velocity (1,0,0) at translate (0,8*i+2*j,0) [Shy]
    process q[i, j] = Cube mass 1 velocity (-1,0,0) at translate (8,8*i+2*j,0) [Shy]
  }
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
  Printf.printf "%d bonds close rings\n" !closings;
  Alcotest.(check bool) "rings close" true (!closings > 20)

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
          quick "order, where groups have several" (fewer Order pairs_in_groups ~with_it:11 ~without:65);
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
