(* What goes on for ever and closes all the same: times after all that is asked about, and bodies that drift apart.
*)

open Scc_ctl
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_evaluate
open Scc_state_space
open Crowds
open Compared
module Gen = QCheck2.Gen

(* A ball between two walls that a law slows down at time 20, once: after that, and not before, its states come
   back. It is from 3 to 7 and back in 8 steps; at time 20 it has been half way once more. *)
let laws_of_time () =
  let text =
    shapes
    ^ {|
fixed west = Cube at translate (0,0,0)
fixed east = Cube at translate (10,0,0)
process p = Cube mass 1 velocity (1,0,0) at translate (4,0,0) [Shy]
motion p = (if time = 20 then vx / 2 else vx, 0, 0)
check goes_on : AG EF touching(p, east)
check slows   : eventually speed2(p) = 1/4
check stays   : AG (speed2(p) < 1 => AG speed2(p) < 1)
check early   : AG (time < 20 => speed2(p) = 1)
|}
  in
  let verdicts, stats = verdicts_and_stats [ Reduction.Time; Jump ] text in
  let holds = "holds (exhaustive)" in
  Alcotest.(check (list string)) "proofs" [ holds; holds; holds; holds ] verdicts;
  Alcotest.(check bool) "all is explored" true stats.complete;
  let _, stats = verdicts_and_stats [ Jump ] text in
  Alcotest.(check bool) "without, it has no end" false stats.complete

let means_of_time () =
  let values reductions =
    let text =
      shapes
      ^ {|
behaviour Lot on Cube = omega(dock, {left, right}) rate 1. nil
process d = p : Cube mass 1 [Lot] <dock, {p.right, q.left}> q : Cube mass 1 at translate (2,0,0) [Lot]
check now   : E = ? [ time at 3 ]
check twice : E = ? [ 2 * time - 1 at 5/2 ]
|}
    in
    fst (verdicts_and_stats reductions text)
  in
  List.iter
    (fun reductions -> Alcotest.(check (list string)) "the time itself" [ "3"; "4" ] (values reductions))
    [ [ Reduction.Jump ]; Reduction.all ]

(* {1 What drifts apart} *)

let drifting name kinds =
  QCheck2.Test.make ~name ~count:75 ~print:Fun.id Drifters.case (agrees kinds ~jump:true ~together:false)

(* A state and the one that stands for it: the same transitions, to states that one stands for, and the same truth
   of all predicates at each instant of what passes until then. [stands_for] is the rule to be tried. *)
type tried = { mutable moved : int; mutable states : int }

let same_truths semantics predicates (s : State.t) (r : State.t) =
  let transitions state =
    match Network.successors semantics state with Ok found -> found | Error _ -> failwith "a law is in error"
  in
  let along state =
    let extent = Trajectory.extent semantics state (transitions state) in
    let trajectory = Trajectory.make semantics state extent in
    List.map (fun p -> Timeline.simplify Truth.equal (Trajectory.prop trajectory p)) predicates
  in
  let equal_piece (a : _ Timeline.piece) (b : _ Timeline.piece) =
    Algebraic.compare a.cut b.cut = 0 && Truth.equal a.at b.at && Truth.equal a.after b.after
  in
  let equal (a : _ Timeline.t) (b : _ Timeline.t) =
    Truth.equal a.start b.start && Truth.equal a.first b.first && List.equal equal_piece a.rest b.rest
  in
  List.for_all2 equal (along s) (along r)

let predicates = List.concat_map (fun (c : Property.check) -> Formula.predicates c.formula)

exception Differs of string

(* Of the first states of a model. *)
let bisimilar tried ~stands_for (e : Scc_elaborate.Elaborate.t) initial =
  let semantics = standard e.model in
  let predicates = predicates e.checks in
  let label (t : Transition.t) = Transition.label_to_string e.model t.label in
  let look (s, transitions) =
    let r = stands_for s in
    tried.states <- tried.states + 1;
    if not (State.equal s r) then begin
      tried.moved <- tried.moved + 1;
      if not (State.equal r (stands_for r)) then raise (Differs "what stands for it");
      let others = Scc_test_networks.Reach.successors e.model r in
      if List.map label transitions <> List.map label others then raise (Differs "transitions");
      let same (t : Transition.t) (u : Transition.t) = State.equal (stands_for t.target) (stands_for u.target) in
      if not (List.for_all2 same transitions others) then raise (Differs "targets");
      if not (same_truths semantics predicates s r) then raise (Differs "truths")
    end
  in
  List.iter look (Scc_test_networks.Reach.states e.model initial ~limit:60)

(* By the rule, alone. *)
let by_rule (e : Scc_elaborate.Elaborate.t) initial =
  match Drift.make e.model initial e.checks with
  | None -> None
  | Some d ->
    let quotient = { Quotient.none with drift = Some d } in
    let catalogue = Catalogue.create ~marked:false ~time_seen:Always ~memory:1024 e.model in
    let within = Quotient.within quotient catalogue in
    Some (fun s -> Catalogue.encode catalogue s |> Quotient.representative within |> Catalogue.decode catalogue)

let by_rule_tried = { moved = 0; states = 0 }

(* The model as it is written, or turned, so that nothing is along the axes. *)
let seen_by view (e : Scc_elaborate.Elaborate.t) =
  let { Seen.model; declared; checks; _ } = view.Seen.see (Seen.of_elaborated e) in
  { e with model; declared; checks }

let stands_for_all =
  QCheck2.Test.make ~name:"Drift: a state and the one that stands for it" ~count:200
    ~print:(fun (text, view) -> text ^ Option.fold ~none:"" ~some:(fun v -> "\nseen by " ^ v.Seen.name) view)
    (Gen.pair Drifters.with_predicates (Gen.option ~ratio:0.3 Seen.any)) (fun (text, view) ->
        let turned (e, _) =
          let e = Option.fold ~none:e ~some:(fun view -> seen_by view e) view in
          match Network.initial (standard e.Scc_elaborate.Elaborate.model) e.declared with
          | Error _ -> None
          | Ok initial -> Option.map (fun rule -> (e, initial, rule)) (by_rule e initial)
        in
        match Option.bind (load text) turned with
        | None -> true
        | Some (e, initial, stands_for) -> (
            match bisimilar by_rule_tried ~stands_for e initial with
            | () -> true
            | exception Differs what -> QCheck2.Test.fail_report what))

let enough () =
  if by_rule_tried.moved < 2000 then
    Alcotest.failf "of %d states only %d are moved" by_rule_tried.states by_rule_tried.moved

(* {1 By hand} *)

let loaded text = match load text with Some x -> x | None -> Alcotest.fail "the model is refused"
let is_complete (s : Scc_verify.Stats.t) = s.complete
let holds = "holds (exhaustive)"

let closes name text ~verdicts:expected ~states () =
  let verdicts, stats = verdicts_and_stats Reduction.all (shapes ^ Drifters.behaviours ^ text) in
  Alcotest.(check (list string)) name expected verdicts;
  Alcotest.(check bool) "all is explored" true (is_complete stats);
  Alcotest.(check int) "states" states stats.states;
  let without = List.filter (fun k -> not (Reduction.equal Drift k)) Reduction.all in
  let _, stats = verdicts_and_stats without (shapes ^ Drifters.behaviours ^ text) in
  Alcotest.(check bool) "without, it has no end" false (is_complete stats)

let pair ?(velocity = 0) ?(behaviour = "Held") ?(x = 0) () =
  Printf.sprintf
    "process d = p : Cube mass 1 velocity (%d,0,0) at translate (%d,0,0) [%s] <dock, {p.right, q.left}>\n\
     q : Cube mass 1 velocity (%d,0,0) at translate (%d,0,0) [%s]\n"
    velocity x behaviour velocity (x + 2) behaviour

let cube ?(mass = 1) ?(velocity = "(0,0,0)") ?(behaviour = "Shy") name x =
  Printf.sprintf "process %s = Cube mass %d velocity %s at translate (%d,0,0) [%s]\n" name mass velocity x
    behaviour

(* Bound or not, at a split instant: how far the third has got does not count. *)
let one_leaves =
  closes "one leaves" ~states:2 ~verdicts:[ holds; "violated"; holds ]
    (pair () ^ cube "r" 6 ~velocity:"(1,0,0)"
     ^ "check a : AG EF bonds(dock) = 0\ncheck b : eventually bonds(dock) = 0\n\
        check c : AG not touching(q, r)\n")

(* At 3k/2 and at 3k/2 + 1, whatever k is. *)
let both_pulse =
  closes "both pulse" ~states:2 ~verdicts:[ holds ]
    (cube "p" 0 ~velocity:"(-1,0,0)" ~behaviour:"Pulse" ^ cube "q" 4 ~velocity:"(1,0,0)" ~behaviour:"Pulse"
     ^ "check a : AG AF (behaviour(p) = Rest and behaviour(q) = Rest)\n")

(* At the time t the box around the pair ends at 3, and that around r begins at 5 + t: the gap is more than 10 from
   9 on, and all later times are one. Each of these 10 as long as the pair is bound, and right after it has split,
   when nothing is left to happen. *)
let up_to_a_distance =
  closes "up to a distance" ~states:20 ~verdicts:[ holds; "violated" ]
    (pair () ^ cube "r" 6 ~velocity:"(1,0,0)"
     ^ "check a : AG (distance2(p, r) <= 100 or EF bonds(dock) = 0)\n\
        check b : AG (bonds(dock) = 1 => distance2(p, r) <= 100)\n")

(* The box around the pair begins at t - 1, which is beyond 10 from 12 on: 13 of each. *)
let up_to_a_place =
  closes "up to a place" ~states:26 ~verdicts:[ holds; "violated" ]
    (pair ~velocity:1 ()
     ^ "check a : AG (x(p) <= 10 or EF bonds(dock) = 0)\ncheck b : AG (bonds(dock) = 1 => x(p) <= 10)\n")

(* It is beyond 3 from 5 on, and so is the time beyond 4: 6 of each. *)
let and_time =
  closes "a place and a time" ~states:12 ~verdicts:[ holds ]
    (pair ~velocity:1 () ^ "check a : AG (time > 4 and x(p) > 3 => EF bonds(dock) = 0)\n")

(* Between two walls: at the start, and before and after each bounce. The third is faster than that, and so apart.
*)
let shuttle =
  closes "one leaves a shuttle" ~states:5 ~verdicts:[ holds ]
    ("fixed west = Cube at translate (-5,0,0)\nfixed east = Cube at translate (5,0,0)\n"
     ^ cube "p" 0 ~velocity:"(1,0,0)"
     ^ "process r = Cube mass 1 velocity (0,0,2) at translate (0,0,20) [Shy]\n"
     ^ "check back : AG EF event bounce(p)\n")

(* What is left to chance makes no difference to that, nor in which direction somebody leaves: bound, at a split
   instant, to be released, released. *)
let gone = "behaviour Gone = omega(dock, {left, right}) chance 1/2. Shy\n"

let leaves_by_lot direction =
  closes "one leaves, by lot" ~states:4 ~verdicts:[ "4"; holds ]
    (gone ^ pair ~behaviour:"Gone" ()
     ^ cube "r" 6 ~velocity:direction
     ^ "check life : E = ? [ time U bonds(dock) = 0 ]\ncheck b : EF bonds(dock) = 0\n")

(* Two pairs leave each other, and the lots of an instant are one transition. While both are bound: at the start,
   at a split instant, and when lots are drawn, unless both are kept (3); then 3 of each pair alone; and the
   end. *)
let pairs_by_lot (x, y) =
  closes "two pairs, by lot" ~states:12 ~verdicts:[ "4"; holds ]
    (gone ^ pair ~behaviour:"Gone" ()
     ^ Printf.sprintf
       "process e = r : Cube mass 1 velocity (%s,%s,0) at translate (0,9,0) [Gone] <dock, {r.right, s.left}>\n\
        s : Cube mass 1 velocity (%s,%s,0) at translate (2,9,0) [Gone]\n"
       x y x y
     ^ "check life : E = ? [ time U not bound(p, q) ]\ncheck b : EF bonds(dock) = 0\n")

let any_direction closes directions () = List.iter (fun direction -> closes direction ()) directions

(* One that sees a place for ever does not keep another one from being proved. *)
let spoils_nothing () =
  let pair = pair ~velocity:1 () ^ cube "r" (-6) in
  let text = pair ^ "check a : AG x(p) = time\ncheck b : AG (x(p) > 3 => EF bonds(dock) = 0)\n" in
  let verdicts, stats = verdicts_and_stats Reduction.all (shapes ^ text) in
  Alcotest.(check (list string))
    "verdicts" [ "holds up to the bound: the bound of 3000 states (a default)"; holds ] verdicts;
  Alcotest.(check bool) "and is not closed" false (is_complete stats)

(* The groups, by the first leaves of their processes; somebody pulses, or nothing would be left to explore. *)
let groups ?(checks = "") text =
  let e, initial = loaded (shapes ^ Drifters.behaviours ^ text ^ checks) in
  let name i = e.model.leaves.(initial.processes.(i).leaves.(0).leaf).name in
  match Drift.make e.model initial e.checks with
  | None -> Alcotest.fail "the rule is off"
  | Some d -> List.map (fun g -> String.concat "" (List.map name g)) (Drift.groups d initial.processes)

let are ?checks name expected text = Alcotest.(check (list string)) name expected (groups ?checks text)

let body ?mass ?behaviour name x velocity =
  cube ?mass ?behaviour name x ~velocity:(Printf.sprintf "(%s,0,0)" velocity)

let pulsing = body ~behaviour:"Pulse"

(* p, of mass 2 and the velocity 1, hits q, which gets 4/3: the velocity of the two is 2/3, and the energy in that
   frame is that of q going 2/3 faster. So r is ahead of both for ever if it is faster than 4/3. *)
let spreads () =
  are "what rests is left" [ "q"; "r" ] (body "q" 6 "0" ^ pulsing "r" 12 "1/100");
  are "what touches is not apart yet" [ "qr" ] (body "q" 6 "0" ^ pulsing "r" 8 "1/100");
  are "nor what does not get farther" [ "qr" ] (body "q" 6 "1" ^ pulsing "r" 12 "1");
  are "nor who comes nearer" [ "qr" ] (body "q" 6 "2" ^ pulsing "r" 12 "1");
  let hit velocity = body ~mass:2 "p" 0 "1" ^ body "q" 6 "0" ^ pulsing "r" 12 velocity in
  are "q may become faster" [ "pqr" ] (hit "6/5");
  are "and as fast" [ "pqr" ] (hit "4/3");
  are "but no faster" [ "pq"; "r" ] (hit "1334/1000");
  let walled velocity = "fixed w = Cube at translate (-20,0,0)\n" ^ body "p" 0 "-1" ^ pulsing "r" 12 velocity in
  are "thrown back by a wall" [ "wpr" ] (walled "1");
  are "not as fast" [ "wp"; "r" ] (walled "101/100");
  are "what comes to a wall" [ "wp" ] ("fixed w = Cube at translate (-20,0,0)\n" ^ pulsing "p" 0 "-1")

(* The pieces of a pair of cubes of mass 1 that is pushed apart by 1 + 1 have the velocities 2 and -2. *)
let pushes () =
  let thrown behaviour velocity = pair ~behaviour () ^ body "r" 6 velocity ^ pulsing "s" 12 "9" in
  are "no push" [ "p"; "r"; "s" ] (thrown "Held" "1");
  are "a push, and nothing is known" [ "prs" ] (thrown "Thrust" "1");
  are "of one leaf there is nothing to push" [ "p"; "r"; "s" ]
    (body ~behaviour:"Thrust" "p" 0 "0" ^ body ~behaviour:"Thrust" "r" 6 "1" ^ pulsing "s" 12 "9")

let limits () =
  let two = body "q" 6 "0" ^ pulsing "r" 18 "1" in
  let check text = "check c : possibly " ^ text ^ "\n" in
  are "a gap of 10, as far as is seen" [ "q"; "r" ] two ~checks:(check "distance2(q, r) > 99");
  are "up to where it is compared with" [ "qr" ] two ~checks:(check "distance2(q, r) > 100");
  are "with the bounds of what else there is" [ "qr" ] two ~checks:(check "distance2(q, r) > 98 + processes");
  are "always" [ "qr" ] two ~checks:(check "distance2(q, r) > x(q)");
  are "beyond a place" [ "q"; "r" ] two ~checks:(check "x(r) > 16");
  let walled = "fixed w = Cube at translate (-20,0,0)\n" ^ two in
  are "a place that is reached" [ "wq"; "r" ] (walled ^ check "x(r) > 16");
  are "and one that is not" [ "wqr" ] (walled ^ check "x(r) > 17");
  are "on the other side" [ "wq"; "r" ] (walled ^ check "x(r) > -30 and x(r) < 16");
  are "where another one is" [ "wq"; "r" ] (walled ^ check "x(q) = 6")

let off () =
  let is name text =
    let e, initial = loaded (shapes ^ Drifters.behaviours ^ text) in
    Alcotest.(check bool) name true (Option.is_none (Drift.make e.model initial e.checks))
  in
  let apart = body "q" 6 "0" ^ pulsing "r" 12 "1" in
  is "nothing is left to happen" (body "q" 6 "0" ^ body "r" 12 "1");
  let e, initial = loaded (shapes ^ "fixed w = Cube\n" ^ body "r" 30 "1") in
  Alcotest.(check bool) "but something is fixed" true (Option.is_some (Drift.make e.model initial []));
  is "a law" (apart ^ "motion r = (vx, vy, vz)\n");
  is "rounding" (apart ^ "round velocity 2^-10\n");
  is "turning" (apart ^ "dynamics constant_spin\nresolution 2^-20\n");
  is "angular momentum" (apart ^ "check c : always angular.z = 0\n")

(* A rule that would not do: r is left to itself as soon as nobody flies towards it. *)
let teeth () =
  let bodies = body ~mass:2 "p" 0 "1" ^ body "q" 6 "0" ^ pulsing "r" 12 "6/5" in
  let e, initial = loaded (shapes ^ Drifters.behaviours ^ bodies) in
  let far = Scc_exact.Vec.of_ints 1000 0 0 in
  let stands_for (s : State.t) =
    let move (p : State.process) =
      let alone = e.model.leaves.(p.leaves.(0).leaf).name = "r" in
      let is_slower (q : State.process) = Rat.compare q.velocity.x p.velocity.x <= 0 in
      if alone && Array.for_all is_slower s.processes then
        State.map_leaves (fun l -> { l with position = far }) p
      else p
    in
    State.make ~processes:(List.map move (Array.to_list s.processes)) ~step:s.step ~time:s.time
  in
  (match bisimilar { moved = 0; states = 0 } ~stands_for e initial with
   | () -> Alcotest.fail "it is not noticed"
   | exception Differs _ -> ());
  match by_rule e initial with
  | None -> Alcotest.fail "the rule is off"
  | Some stands_for -> bisimilar { moved = 0; states = 0 } ~stands_for e initial

let () =
  let quick name f = Alcotest.test_case name `Quick f in
  Alcotest.run "closing"
    [
      ( "time",
        [
          quick "laws that look at time up to a constant" laws_of_time;
          quick "a mean sees all of the time" means_of_time;
        ] );
      ( "drift",
        Scc_test_support.Property.cases
          [
            drifting "Fragments: drift" [ Reduction.Drift; Jump ];
            drifting "Fragments: drift, and all else" Reduction.all;
            stands_for_all;
          ]
        @ [ quick "enough is moved" enough ] );
      ( "groups",
        [
          quick "how much velocities spread" spreads;
          quick "pushes" pushes;
          quick "places that are seen" limits;
          quick "where the rule is off" off;
          quick "a weaker rule is noticed" teeth;
        ] );
      ( "closing",
        [
          quick "one leaves" one_leaves; quick "both pulse" both_pulse; quick "up to a distance" up_to_a_distance;
          quick "in any direction, by lot"
            (any_direction leaves_by_lot [ "(1,0,0)"; "(0,-1,0)"; "(0,1/9,1)"; "(3,-4,5)"; "(1/7,0,-2)" ]);
          quick "two pairs in any direction, by lot"
            (any_direction pairs_by_lot [ ("0", "1"); ("1", "0"); ("-1/5", "1/7"); ("1", "1") ]);
          quick "one leaves a shuttle" shuttle; quick "up to a place" up_to_a_place;
          quick "a place and a time" and_time;
          quick "places spoil no other property" spoils_nothing;
        ] );
    ]
