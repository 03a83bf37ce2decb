(* Rule Round on small networks, by hand. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Fixture
open Rigid_fixture

let standard = Scc_engine.Standard.of_model

let setting m = (standard m).Semantics.setting
let apart_from_all m s i ~by = Turning.apart (setting m) s i ~by

let round m s =
  let semantics = standard m in
  Turning.begin_step semantics.setting ~collides:(Collisions.collides semantics) s

let apart () =
  let bodies = [ body "p" (0, 0, 0); body "q" (3, 0, 0); body "r" (0, 40, 0) ] in
  let m = rigid (model bodies) in
  let s = declared bodies in
  let check what expected i by = Alcotest.(check bool) what expected (apart_from_all m s i ~by) in
  check "exactly as far is not farther" false 0 (q 1);
  check "farther" true 0 (ratio 999 1000);
  check "the other way round" false 1 (q 1);
  check "alone" true 2 (q 30);
  check "not so alone" false 2 (q 39);
  let touching = declared [ body "p" (0, 0, 0); body "q" (2, 0, 0); body "r" (0, 40, 0) ] in
  Alcotest.(check bool) "touching" false (apart_from_all m touching 0 ~by:Rat.zero)

let long = quaternion 1_000_003 77_777 3 999

let orientation () =
  let bodies = [ body "p" (0, 0, 0); body "q" (40, 0, 0) ] in
  let m = rigid ~rounding:8 (model bodies) in
  let rounded others =
    let s = turned_by [ long; Quaternion.identity ] (declared others) in
    let s, changed = round m s in
    (s.processes.(0).leaves.(0), Option.is_some changed)
  in
  let leaf, changed = rounded bodies in
  check_turned "to 8 bits" "(64, 5, 0, 0)" leaf.turned;
  Alcotest.(check bool) "it says so" true changed;
  let leaf, changed = rounded [ body "p" (0, 0, 0); body "q" (2, 0, 0) ] in
  check_turned "not where another body is too near" (Quaternion.to_string long) leaf.turned;
  Alcotest.(check bool) "nothing changes" false changed;
  let off = rigid (model bodies) in
  Alcotest.(check bool) "rounding is off" true
    (let s = turned_by [ long; Quaternion.identity ] (declared bodies) in
     let t, changed = round off s in
     State.equal s t && Option.is_none changed)

(* A process is rounded as a whole: its leaves keep their places in it. *)
let whole () =
  let bodies = [ body "p" (-1, 0, 0); body "q" (1, 0, 0) ~mass:2 ] in
  let m = rigid ~rounding:8 (model bodies) in
  let s = joined bodies [ ("a", (0, "right"), (1, "left")) ] in
  let s =
    spinning [ vec (third 1) (third 2) (ratio 1 7) ] s
    |> fun s -> State.make ~processes:[ Turn.pass m (ratio 1 3) s.processes.(0) ] ~step:None ~time:None
  in
  let centre (s : State.t) = State.centre_of_mass m s.processes.(0) in
  let arm (s : State.t) =
    let p = s.processes.(0) in
    Quaternion.apply
      (Quaternion.inverse p.leaves.(0).turned)
      (Vec.sub p.leaves.(1).position p.leaves.(0).position)
  in
  let t, _ = round m s in
  check_vec "the centre of mass stays" (Vec.to_string (centre s)) (centre t);
  check_vec "and the leaves side by side" "(2, 0, 0)" (arm t);
  Alcotest.(check bool) "not long" true (Quaternion.bits t.processes.(0).leaves.(1).turned <= 9);
  Alcotest.(check bool) "they differ" false (State.equal s t)

let velocities () =
  (* Two cubes face to face; the normal is (3, 4, 0). With halves the first would come nearer. *)
  let at = vec (ratio 6 5) (ratio 8 5) Rat.zero in
  let v = vec (ratio 26 100) (ratio (-2) 10) Rat.zero in
  let m = rigid ~rounding:1 (model [ body "p" (0, 0, 0); body "q" (0, 0, 0) ]) in
  let place (s : State.t) =
    let far = State.map_leaves (fun l -> { l with State.position = at }) s.processes.(1) in
    State.make ~processes:[ s.processes.(0); far ] ~step:None ~time:None
  in
  let s =
    declared [ body "p" (0, 0, 0); body "q" (0, 0, 0) ]
    |> place |> moving [ v; Vec.zero ]
    |> turned_by [ quaternion 2 0 0 1; quaternion 2 0 0 1 ]
  in
  Alcotest.(check bool) "they do not collide" true (not (Collisions.collides (standard m) s));
  let t, changed = round m s in
  Alcotest.(check bool) "it waits" true (State.equal s t && Option.is_none changed);
  let away = moving [ Vec.neg v; Vec.zero ] s in
  let t, _ = round m away in
  check_vec "-26/100 and 2/10, to halves" "(-1/2, 0, 0)" t.processes.(0).velocity

(* Alone and without spin, but what waits to be rounded goes another way from the next step on. *)
let waiting () =
  let bodies = [ body "p" (0, 0, 0) ] in
  let m = rigid ~rounding:1 (model bodies) in
  let step = Some { State.remaining = ratio 1 3; length = q 1; phase = State.Steered } in
  let s = State.make ~processes:(Array.to_list (declared bodies).processes) ~step ~time:None in
  let waits what s = Alcotest.(check bool) what false (Network.quiescent (standard m) s) in
  Alcotest.(check bool) "nothing to round" true (Network.quiescent (standard m) s);
  waits "a velocity" (moving [ vec (ratio 2 3) Rat.zero Rat.zero ] s);
  let turned = turned_by [ quaternion 9 0 0 1 ] s in
  waits "an orientation" turned;
  let rounded = take m turned "time(1/3)" in
  check_turned "it was rounded" "(1, 0, 0, 0)" rounded.processes.(0).leaves.(0).turned;
  Alcotest.(check bool) "and then rests" true (Network.quiescent (standard m) rounded)

(* What a free body keeps is rounded once, and then kept, however the body turns: to multiples of 1/512 here, as
   the trace of its inertia is 7/8. *)
let free () =
  let bodies = [ body "p" (0, 0, 0) ] in
  let m = rigid ~dynamics:Free_body ~rounding:8 (planks (model bodies)) in
  let s = turned_by [ quaternion 3 1 0 2 ] (declared bodies) in
  let p = Turn.start m (List.hd (Array.to_list (spinning [ vec (third 1) (third 2) (ratio 1 7) ] s).processes)) in
  let rounded p = (fst (round m (State.make ~processes:[ p ] ~step:None ~time:None))).processes.(0) in
  let once = rounded p in
  check_vec "not far from what it was" "(9/256, 39/512, -1/128)" once.kept;
  Alcotest.(check bool) "as all else" true (Round.settled m once);
  let later = rounded (Turn.renew m (Turn.pass m (ratio 1 4) once)) in
  check_vec "kept" (Vec.to_string once.kept) later.kept;
  Alcotest.(check bool) "the spin changes" false (Vec.equal once.spin later.spin)

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "round"
    [
      ("room", [ case "apart" apart ]);
      ( "round",
        [
          case "orientations" orientation; case "a process as a whole" whole; case "velocities wait" velocities;
          case "no rest before it is rounded" waiting; case "angular momenta" free;
        ] );
    ]
