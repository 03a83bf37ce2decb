(* Rule Round on small networks, by hand. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Fixture
open Rigid_fixture

let standard = Scc_engine.Standard.of_model

(* As turns of all begin. *)
let round m (s : State.t) =
  let semantics = standard m in
  let due = List.map (Turn.renew m) (Array.to_list s.processes) in
  let due = State.make ~processes:due ~step:s.step ~time:s.time in
  let parts (s : State.t) = Collisions.parts semantics s.processes in
  Turning.begin_turns semantics.setting ~parts ~colliding:(Collisions.colliding semantics) due

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
  let waits what others =
    let leaf, changed = rounded others in
    check_turned what (Quaternion.to_string long) leaf.turned;
    Alcotest.(check bool) "nothing changes" false changed
  in
  waits "not where another body is too near" [ body "p" (0, 0, 0); body "q" (2, 0, 0) ];
  let off = rigid (model bodies) in
  Alcotest.(check bool) "rounding is off" true
    (let s = turned_by [ long; Quaternion.identity ] (declared bodies) in
     let t, changed = round off s in
     Quaternion.equal long t.processes.(0).leaves.(0).turned && Option.is_none changed)

(* With 8 bits a point of a cube moves by no more than 2 sqrt(3) 2/256 < 1/32. Both may move. *)
let room () =
  let m = rigid ~rounding:8 (model [ body "p" (0, 0, 0); body "q" (0, 0, 0) ]) in
  let rounded gap both =
    let far = State.map_leaves (fun l -> { l with State.position = vec (Rat.add (q 2) gap) Rat.zero Rat.zero }) in
    let s = declared [ body "p" (0, 0, 0); body "q" (0, 0, 0) ] in
    let s = State.make ~processes:[ s.processes.(0); far s.processes.(1) ] ~step:None ~time:None in
    let few = quaternion 1_000_000 1 0 0 in
    let s, _ = round m (turned_by [ few; (if both then few else Quaternion.identity) ] s) in
    List.map (fun (p : State.process) -> Quaternion.is_identity p.leaves.(0).turned) (Array.to_list s.processes)
  in
  let check what expected found = Alcotest.(check (list bool)) what expected found in
  check "far enough for one" [ true; true ] (rounded (ratio 1 32) false);
  check "not for two" [ false; false ] (rounded (ratio 1 60) true);
  check "far enough for two" [ true; true ] (rounded (ratio 1 15) true);
  check "not for one" [ false; true ] (rounded (ratio 1 200) false)

(* What two cubes of masses 1 and 2 have after a bounce, to quarters; not before they have done with each other. *)
let straight () =
  let bodies =
    [
      body "p" (-4, 0, 0) ~velocity:(1, 0, 0);
      body "q" (0, 0, 0) ~mass:2;
      body "r" (0, 2, 0) ~velocity:(0, -1, 0) ~mass:2;
    ]
  in
  let m = { (model bodies) with round_velocity = Some 2 } in
  let s = start m (declared bodies) in
  (* r and q exchange their velocities at once, and no turn is due any more *)
  let s = take m s "bounce(q, r)" in
  let check_velocities what expected (s : State.t) =
    Alcotest.(check (list string)) what expected
      (List.map (fun (p : State.process) -> Vec.to_string p.velocity) (Array.to_list s.processes))
  in
  let due (s : State.t) = List.map Turn.due (Array.to_list s.processes) in
  Alcotest.(check (list bool)) "all have begun" [ false; false; false ] (due s);
  let row = [ body "p" (0, 0, 0) ~velocity:(1, 0, 0); body "q" (2, 0, 0) ~mass:2; body "r" (4, 0, 0) ~mass:2 ] in
  let m = { (model row) with round_velocity = Some 2 } in
  let s = start m (declared row) in
  Alcotest.(check (list bool)) "due while they collide" [ true; true; false ] (due s);
  let s = take m s "bounce(p, q)" in
  check_velocities "p is rounded, q still hits r" [ "(-1/4, 0, 0)"; "(2/3, 0, 0)"; "(0, 0, 0)" ] s;
  let s = take m s "bounce(q, r)" in
  check_velocities "then r is" [ "(-1/4, 0, 0)"; "(0, 0, 0)"; "(3/4, 0, 0)" ] s;
  Alcotest.(check bool) "well-formed" true (Well_formed.check (standard m) s = [])

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
  let names = [ body "p" (0, 0, 0); body "q" (0, 0, 0); body "r" (90, 0, 0) ] in
  let m = rigid ~rounding:1 (model names) in
  let place (s : State.t) =
    let far = State.map_leaves (fun l -> { l with State.position = at }) s.processes.(1) in
    State.make ~processes:[ s.processes.(0); far; s.processes.(2) ] ~step:None ~time:None
  in
  let third = vec (ratio 2 3) Rat.zero Rat.zero in
  let s =
    declared names
    |> place |> moving [ v; Vec.zero; third ]
    |> turned_by [ quaternion 2 0 0 1; quaternion 2 0 0 1; Quaternion.identity ]
  in
  Alcotest.(check bool) "they do not collide" true (not (Collisions.collides (standard m) s));
  let t, changed = round m s in
  check_vec "it waits" (Vec.to_string v) t.processes.(0).velocity;
  check_vec "others do not" "(1/2, 0, 0)" t.processes.(2).velocity;
  Alcotest.(check bool) "and it says so" true (Option.is_some changed);
  let away = moving [ vec (ratio (-2) 5) (ratio 1 5) Rat.zero; Vec.zero; third ] s in
  let t, _ = round m away in
  check_vec "-2/5 and 1/5, to halves" "(-1/2, 0, 0)" t.processes.(0).velocity

(* Whoever collides is not rounded before that is over. *)
let colliding () =
  let bodies = [ body "p" (0, 0, 0) ~velocity:(1, 0, 0); body "q" (2, 0, 0); body "r" (0, 50, 0) ] in
  let m = rigid ~rounding:1 (model bodies) in
  let slow = vec (ratio 1 3) Rat.zero Rat.zero in
  let s = moving [ slow; Vec.zero; slow ] (declared bodies) in
  let t, _ = round m s in
  check_vec "not yet" (Vec.to_string slow) t.processes.(0).velocity;
  Alcotest.(check bool) "its turn is due" true (Turn.due t.processes.(0));
  check_vec "at once" "(1/2, 0, 0)" t.processes.(2).velocity

(* What spins goes another way from its next turn on if something of it waits to be rounded. What does not spin has
   no further turn. *)
let waiting () =
  let m = rigid ~rounding:1 (model [ body "p" (0, 0, 0) ]) in
  let still = declared [ body "p" (0, 0, 0) ] in
  let begun spin (s : State.t) =
    let s = spinning [ spin ] s in
    State.make ~processes:[ Turn.begun m s.processes.(0) ] ~step:None ~time:None
  in
  let slow = moving [ vec (ratio 2 3) Rat.zero Rat.zero ] still in
  let rests what expected s = Alcotest.(check bool) what expected (Network.quiescent (standard m) s) in
  rests "nothing to round" true (begun (ints 0 0 1) still);
  rests "a velocity" false (begun (ints 0 0 1) slow);
  rests "a spin" false (begun (vec Rat.zero Rat.zero (third 1)) still);
  rests "without a spin" true (begun Vec.zero slow);
  let rounded = take m (begun (ints 0 0 1) slow) "time(1/2)" in
  check_vec "it was rounded" "(1/2, 0, 0)" rounded.processes.(0).velocity;
  rests "and then rests" true rounded

(* In any order of declaration: the reference of an orientation is none of the order of leaves. *)
let reference () =
  let bodies = [ body "p" (-1, 0, 0); body "q" (1, 0, 0) ] in
  let turned first second =
    let m = rigid ~rounding:8 (model bodies) in
    let s = joined bodies [ ("a", (0, "right"), (1, "left")) ] in
    let turn (l : State.leaf) = { l with turned = (if l.leaf = 0 then first else second) } in
    let s = State.make ~processes:[ State.map_leaves turn s.processes.(0) ] ~step:None ~time:None in
    let t, changed = round m s in
    let of_leaf i = Quaternion.to_string t.processes.(0).leaves.(i).turned in
    (of_leaf 0, of_leaf 1, Option.is_some changed)
  in
  let other = quaternion 400 3 1 0 in
  let a, b, changed = turned long other and b', a', changed' = turned other long in
  Alcotest.(check (pair string string)) "the same" (a, b) (a', b');
  Alcotest.(check (pair bool bool)) "it was rounded" (true, true) (changed, changed');
  Alcotest.(check string) "the shorter to 8 bits" "(256, 2, 1, 0)" b;
  let _, _, changed = turned long (quaternion 20 3 1 0) in
  Alcotest.(check bool) "one that is short is enough" false changed

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

(* The spin of a free body is what its angular momentum gives it as it is turned after rounding, not before, also
   if its angular momentum needs no rounding. *)
let free_turned () =
  let bodies = [ body "p" (0, 0, 0) ] in
  let m = rigid ~dynamics:Free_body ~rounding:8 (planks (model bodies)) in
  let s = turned_by [ long ] (declared bodies) in
  let kept = vec (ratio 9 256) (ratio 39 512) (ratio (-1) 128) in
  let p = Turn.renew m (State.with_kept kept (Turn.start m s.processes.(0))) in
  let before = State.make ~processes:[ p ] ~step:None ~time:None in
  let after, changed = Round.run m ~colliding:(fun _ -> []) ~near:(fun _ _ -> []) before [ 0 ] in
  let after = after.processes.(0) in
  Alcotest.(check bool) "it was rounded" true changed;
  check_turned "to 8 bits" "(64, 5, 0, 0)" after.leaves.(0).turned;
  let momentum (p : State.process) =
    let mass = Option.get (Turn.mover m p).mass in
    Scc_rigid.Mass.angular_momentum mass ~velocity:Vec.zero ~spin:p.spin ~about:(State.centre_of_mass m p)
  in
  check_vec "what it keeps" (Vec.to_string kept) after.kept;
  check_vec "its angular momentum by its spin" (Vec.to_string kept) (momentum after);
  Alcotest.(check bool) "the spin is another one" false (Vec.equal p.spin after.spin)

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("round",
   [
     ("room", [ case "room for those that are rounded" room ]);
     ( "round",
       [
         case "orientations" orientation; case "where nothing turns" straight;
         case "a process as a whole" whole; case "velocities wait" velocities;
         case "not while it collides" colliding; case "the reference of an orientation" reference;
         case "no rest before it is rounded" waiting; case "angular momenta" free;
         case "the spin of what was turned" free_turned;
       ] );
   ])
