(* Rules Turn, Cast and Near on small networks, by hand. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Fixture
open Rigid_fixture

let standard = Scc_engine.Standard.of_model

(* {1 Turn} *)

let length () =
  let m = rigid (model [ body "p" (0, 0, 0) ]) in
  let length x y = Turn.length m (vec Rat.zero x y) in
  check_rat "no spin" "0" (length Rat.zero Rat.zero);
  check_rat "just slow enough" "1" (length (ratio 1 2) Rat.zero);
  check_rat "hardly too fast" "1/2" (length Rat.zero (ratio 501 1000));
  check_rat "half a timestep is enough up to twice that" "1/2" (length (q 1) Rat.zero);
  check_rat "all of the spin counts" "1/4" (length (q 1) (ratio (-1) 3));
  check_rat "fast" "1/64" (length Rat.zero (q (-17)))

let pass () =
  (* u = spin t / 2 = (0, 0, 1): a quarter turn *)
  let bodies = [ body "p" (1, 0, 0); body "q" (3, 0, 0) ~mass:3 ] in
  let m = rigid (model bodies) in
  let s = joined ~velocity:(1, 0, 0) bodies [ ("a", (0, "right"), (1, "left")) ] in
  let p = State.with_turn ~spin:(ints 0 0 2) ~since:Rat.zero ~lasts:None s.processes.(0) in
  check_vec "the centre of mass" "(5/2, 0, 0)" (State.centre_of_mass m p);
  let after = Turn.pass m (q 1) p in
  check_vec "it moves on" "(7/2, 0, 0)" (State.centre_of_mass m after);
  check_vec "the first leaf" "(7/2, -3/2, 0)" after.leaves.(0).position;
  check_vec "the second leaf" "(7/2, 1/2, 0)" after.leaves.(1).position;
  check_turned "both are turned" "(1, 0, 0, 1)" after.leaves.(1).turned;
  check_rat "the turn goes on" "1" after.since;
  let twice = Turn.pass m (ratio 2 3) (Turn.pass m (third 1) p) in
  Alcotest.(check bool) "in two goes" true (State.equal_process after twice);
  (* the map is not additive across turns *)
  let anew = Turn.pass m (ratio 2 3) (Turn.renew m (Turn.pass m (third 1) p)) in
  Alcotest.(check bool) "with a new turn in between" false (State.equal_process after anew)

let momentum m (p : State.process) =
  let mover = Turn.mover m p in
  match mover.mass with
  | Some mass ->
    Scc_rigid.Mass.angular_momentum mass ~velocity:p.velocity ~spin:p.spin ~about:(State.centre_of_mass m p)
  | None -> Alcotest.fail "it is fixed"

let begun m p = match Turn.midway m p with Some p -> p | None -> Alcotest.fail "it is not free"

let renew () =
  let bodies = [ body "p" (0, 0, 0) ] in
  let free = rigid ~dynamics:Free_body (planks (model bodies)) in
  let constant = rigid (planks (model bodies)) in
  let start m spin =
    Turn.start m (State.with_turn ~spin ~since:Rat.zero ~lasts:None (declared bodies).processes.(0))
  in
  let after m p = Turn.renew m (Turn.pass m (ratio 1 3) p) in
  let spin = vec (q 1) (ratio 1 2) (third 1) in
  let tumbling = start free spin in
  let renewed = after free tumbling in
  check_rat "a new turn" "0" renewed.since;
  Alcotest.(check bool) "the spin of a free body changes" false (Vec.equal tumbling.spin renewed.spin);
  check_vec "its angular momentum stays" (Vec.to_string (momentum free tumbling)) (momentum free renewed);
  check_vec "a constant spin" (Vec.to_string spin) (after constant (start constant spin)).spin;
  let steady = start free (ints 0 2 0) in
  check_vec "about a principal axis" "(0, 2, 0)" (after free steady).spin;
  check_vec "half-way about a principal axis" "(0, 2, 0)" (begun free steady).spin;
  Alcotest.(check bool) "nothing to renew" true (State.equal_process tumbling (Turn.renew free tumbling))

(* The energy of a free body that tumbles wanders a little and does not grow: with the spin of the start of each
   turn it would double within these turns. *)
let midway () =
  let free = rigid ~dynamics:Free_body (planks (model [ body "p" (0, 0, 0) ])) in
  let energy p =
    let mover = Turn.mover free p in
    Rat.to_float (Scc_rigid.Mass.energy (Option.get mover.mass) ~velocity:Vec.zero ~spin:mover.spin)
  in
  let short (p : State.process) =
    let near x = Rat.round_to x ~quantum:(ratio 1 1_000_000) in
    let leaf (l : State.leaf) = { l with turned = Quaternion.round 40 l.turned } in
    State.map_leaves leaf
      (State.with_turn ~spin:(vec (near p.spin.x) (near p.spin.y) (near p.spin.z)) ~since:p.since ~lasts:p.lasts p)
  in
  let turn p =
    let p = short (begun free p) in
    check_rat "a quarter of a timestep" "1/4" (Option.get p.lasts);
    Turn.ended free (Turn.pass free (ratio 1 4) p)
  in
  let first =
    Turn.start free
      (State.with_turn ~spin:(vec (q 1) (ratio 1 2) (third 1)) ~since:Rat.zero ~lasts:None
         (declared [ body "p" (0, 0, 0) ]).processes.(0))
  in
  let rec run n p = if n = 0 then p else run (n - 1) (turn p) in
  let ratio = energy (run 200 first) /. energy first in
  Alcotest.(check bool) (Printf.sprintf "the energy stays (x %.4f)" ratio) true (ratio > 0.98 && ratio < 1.02)

(* Two cubes that spin about the middle between them let go of each other. *)
let piece () =
  let bodies = [ body "p" (-1, 0, 0); body "q" (1, 0, 0) ] in
  let m = rigid (model bodies) in
  let s = joined ~velocity:(0, 0, 5) bodies [ ("a", (0, "right"), (1, "left")) ] in
  let whole = State.with_turn ~spin:(ints 0 0 2) ~since:Rat.zero ~lasts:None s.processes.(0) in
  let alone i =
    State.process ~leaves:[ whole.leaves.(i) ] ~bonds:[] ~velocity:whole.velocity ~clock:None ()
  in
  let p = Turn.piece m ~whole (alone 0) and q' = Turn.piece m ~whole (alone 1) in
  check_vec "one way" "(0, -2, 5)" p.velocity;
  check_vec "the other way" "(0, 2, 5)" q'.velocity;
  check_vec "as it was" "(0, 0, 2)" q'.spin;
  let walls = [ body "p" (-1, 0, 0); body "q" (1, 0, 0) ~fixed:true ] in
  let m = rigid (model walls) in
  let s = joined walls [ ("a", (0, "right"), (1, "left")) ] in
  let whole = s.processes.(0) in
  let p = State.process ~leaves:[ whole.leaves.(0) ] ~bonds:[] ~velocity:Vec.zero ~clock:None () in
  let p = Turn.piece m ~whole p in
  check_vec "from a fixed body: at rest" "(0, 0, 0)" p.velocity;
  check_vec "and without spin" "(0, 0, 0)" p.spin

(* Turns of one process end by themselves and by what happens to it, and not by what happens elsewhere. *)
let own_turns () =
  let bodies =
    [
      body "a" (0, 0, 0); body "b" (100, 0, 0); body "p" (0, 100, 0) ~velocity:(3, 0, 0);
      body "q" (6, 100, 0);
    ]
  in
  let m = rigid (model bodies) in
  let spins = [ vec (ratio 1 2) Rat.zero Rat.zero; ints 4 0 0; Vec.zero; Vec.zero ] in
  let s = start m (spinning spins (declared bodies)) in
  let turn (s : State.t) i =
    let p = s.processes.(i) in
    Rat.to_string p.since ^ " of " ^ Option.fold ~none:"none" ~some:Rat.to_string p.lasts
  in
  let check what expected s i = Alcotest.(check string) what expected (turn s i) in
  check "slow" "0 of 1" s 0;
  check "fast" "0 of 1/8" s 1;
  check "no turn" "0 of 0" s 2;
  check_labels "the first that ends" [ "time(1/8)" ] m s;
  let s = take m s "time(1/8)" in
  check "the slow one goes on" "1/8 of 1" s 0;
  check "another turn" "0 of 1/8" s 1;
  let rec to_contact s =
    match successors m s with
    | [ { Transition.label = Time _; target; _ } ] -> to_contact target
    | _ -> s
  in
  let s = to_contact s in
  check_labels "two that do not turn meet, exactly after 4/3" [ "bounce(p, q)" ] m s;
  check "the slow one is in its second turn" "1/3 of 1" s 0;
  check "the fast one in its eleventh" "1/12 of 1/8" s 1;
  let s = take m s "bounce(p, q)" in
  check "a collision elsewhere is nothing to them" "1/3 of 1" s 0;
  check "neither to the other" "1/12 of 1/8" s 1

(* An instant at which time stops for another reason does not move a contact. *)
let bystander () =
  let spins = [ ints 0 0 1; Vec.zero; Vec.zero ] in
  let met behaviour =
    let far = body "far" (0, 900, 0) ~behaviour in
    let bodies = [ body "p" (0, 0, 0) ~velocity:(3, 0, 0); body "q" (6, 1, 0); far ] in
    let m = rigid (model bodies) in
    let rec go s time =
      match successors m s with
      | [ ({ Transition.label = Time d; _ } as t) ] -> go t.target (Rat.add time d)
      | _ -> (Rat.to_string time, s.State.processes.(0))
    in
    go (start m (spinning spins (declared bodies))) Rat.zero
  in
  let time, p = met nil and other_time, p' = met (eps (ratio 31 30) nil) in
  Alcotest.(check string) "at the same time" time other_time;
  Alcotest.(check bool) "in the same place" true (State.equal_process p p')

(* {1 Cast} *)

let off_centre () =
  (* the cube of p is 5 to the right of p's reference point: its face is at 6, and that of q at 9 *)
  let bodies = [ body "p" (0, 0, 0) ~velocity:(2, 0, 0); body "q" (10, 0, 0) ] in
  let m = model bodies in
  let shift (l : Model.leaf) =
    if l.name <> "p" then l
    else { l with parts = Array.map (fun (p : Model.part) -> { p with Model.offset = ints 5 0 0 }) l.parts }
  in
  let m = rigid { m with leaves = Array.map shift m.leaves } in
  let s = declared bodies in
  let contact (s : State.t) =
    Option.map Rat.to_string (Collisions.first_time_of_contact (standard m) s.processes ~limit:(Some (q 4)))
  in
  Alcotest.(check (option string)) "exact on the grid" (Some "3/2") (contact s);
  (* turned upside down about its centre, nothing changes but where the reference point is *)
  let upside_down = turned_by [ quaternion 0 0 0 1; Quaternion.identity ] s in
  let p = upside_down.processes.(0) in
  check_vec "the centre is behind" "(-5, 0, 0)" (State.centre_of_mass m p);
  let to_left = State.map_leaves (fun l -> { l with State.position = ints 10 0 0 }) p in
  let s = State.make ~processes:[ to_left; s.processes.(1) ] ~step:None ~time:None in
  Alcotest.(check (option string)) "the same" (Some "3/2") (contact s);
  Alcotest.(check (option string)) "not within the limit" None
    (Collisions.first_time_of_contact (standard m) s.State.processes ~limit:(Some (q 1))
     |> Option.map Rat.to_string)

let thirds () =
  (* They meet after 4/3. Where nothing spins that is exact; else it is rounded down to a multiple of 2^-K, counted
     from the start of the turn, with (3 + spin reach) 2^-K <= 1/1024: K = 13. *)
  let bodies = [ body "p" (0, 0, 0) ~velocity:(3, 0, 0); body "q" (6, 0, 0) ] in
  let m = rigid (model bodies) in
  let found ?limit s = Collisions.first_time_of_contact (standard m) s.State.processes ~limit in
  let check what expected s = Alcotest.(check (option string)) what (Some expected) (Option.map Rat.to_string s) in
  let s = declared bodies in
  check "exact" "4/3" (found s);
  let turning = spinning [ ints 1 0 0; Vec.zero ] s in
  check "rounded down" "5461/4096" (found ~limit:(q 2) turning);
  let later = Time.pass (standard m) (ratio 1 3) turning in
  check "wherever time stops before" "12287/12288" (found ~limit:(q 2) later)

(* {1 Bodies that meet} *)

let network ?dynamics ?definitions ?timestep ~spins bodies =
  let m = rigid ?dynamics (model ?definitions ?timestep bodies) in
  (m, start m (spinning (List.map (fun (x, y, z) -> ints x y z) spins) (declared bodies)))

let run m s ~steps =
  let rec go s n found =
    match if n = 0 then [] else successors m s with
    | t :: _ -> go t.Transition.target (n - 1) (s :: found)
    | [] -> List.rev (s :: found)
  in
  go s steps []

(* Mirror images stay mirror images: x becomes -x, and spins are axial. *)
let mirror () =
  let bodies = [ body "p" (-4, 0, 0) ~velocity:(2, 1, 0); body "q" (4, 0, 0) ~velocity:(-2, 1, 0) ] in
  let m, s = network ~spins:[ (1, 1, 1); (1, -1, -1) ] bodies in
  let states = run m s ~steps:40 in
  let flipped (v : Vec.t) = Vec.make (Rat.neg v.x) v.y v.z
  and axial (v : Vec.t) = Vec.make v.x (Rat.neg v.y) (Rat.neg v.z) in
  let check i (s : State.t) =
    let p = s.processes.(0) and q' = s.processes.(1) in
    let what = Printf.sprintf "state %d" i in
    check_vec what (Vec.to_string (flipped p.leaves.(0).position)) q'.leaves.(0).position;
    check_vec what (Vec.to_string (flipped p.velocity)) q'.velocity;
    check_vec what (Vec.to_string (axial p.spin)) q'.spin;
    let { Quaternion.w; x; y; z } = p.leaves.(0).turned in
    let turned = Quaternion.make w x (Z.neg y) (Z.neg z) in
    check_turned what (Quaternion.to_string turned) q'.leaves.(0).turned
  in
  List.iteri check states;
  let last = List.nth states (List.length states - 1) in
  Alcotest.(check bool) "they have met" false
    (Vec.equal last.processes.(0).velocity (List.hd states).processes.(0).velocity)

let fixed_bind () =
  let bodies =
    [
      body "p" (0, 0, 0) ~velocity:(2, 0, 0) ~behaviour:(open_ "a" [ "right" ] nil);
      body "w" (5, 0, 0) ~fixed:true ~behaviour:(co_open "a" [ "left" ] nil);
    ]
  in
  let m, s = network ~timestep:(q 4) ~spins:[ (1, 0, 0); (0, 0, 0) ] bodies in
  let states = run m s ~steps:12 in
  let last = List.nth states (List.length states - 1) in
  Alcotest.(check int) "one process" 1 (Array.length last.processes);
  check_vec "that stands" "(0, 0, 0)" last.processes.(0).velocity;
  check_vec "and does not turn" "(0, 0, 0)" last.processes.(0).spin;
  Alcotest.(check bool) "well-formed" true (Well_formed.check (standard m) last = [])

(* Cubes in a row that meet face to face never turn: it is as if nothing could. *)
let translational () =
  let bodies =
    [
      body "l" (-12, 0, 0) ~fixed:true; body "p" (-7, 0, 0) ~velocity:(3, 0, 0) ~mass:2;
      body "q" (-1, 0, 0) ~velocity:(-1, 0, 0); body "r" (5, 0, 0) ~velocity:(-5, 0, 0) ~mass:3;
      body "w" (13, 0, 0) ~fixed:true;
    ]
  in
  let m = model bodies in
  let events m s =
    let rec go s time n found =
      if n = 0 then List.rev found
      else
        match successors m s with
        | [] -> List.rev found
        | t :: _ ->
          let time = Rat.add time (Transition.duration t) in
          let found =
            match t.label with
            | Time _ -> found
            | _ -> (Transition.label_to_string m t.label, time) :: found
          in
          go t.target time (n - 1) found
    in
    go s Rat.zero 60 []
  in
  let exact = events m (start m (declared bodies)) in
  let rm = rigid m in
  let rigid = events rm (start rm (declared bodies)) in
  let names = List.map fst in
  let n = 15 in
  let first list = List.filteri (fun i _ -> i < n) list in
  Alcotest.(check int) "enough of them" n (List.length (first exact));
  Alcotest.(check (list string)) "the same collisions" (names (first exact)) (names (first rigid));
  List.iter2 (fun (what, a) (_, b) -> check_rat what (Rat.to_string a) b) (first exact) (first rigid)

(* A tip under a face that turns about the face's middle: no point approaches, and yet the face turns into it. *)
let persistent () =
  let solid = Scc_test_networks.Random_rigid.tetrahedron ~id:9 in
  let bodies = [ body "p" (0, 0, 0); body "tip" (0, 0, -4) ~fixed:true ] in
  let m = model bodies in
  let part (p : Model.part) = { p with solid } in
  let tip (l : Model.leaf) = if l.fixed then { l with parts = Array.map part l.parts } else l in
  let m = rigid { m with leaves = Array.map tip m.leaves } in
  (* its corner (0, 0, 3) is at (0, 0, -1) *)
  let s = spinning [ ints 0 1 0; Vec.zero ] (declared bodies) in
  Alcotest.(check int) "they would interpenetrate" 1 (List.length (Collisions.meetings (standard m) s.processes));
  let s = start m s in
  (match Network.successors (standard m) s with
   | Error (Persistent_contact [ 0; 1 ]) -> ()
   | Error _ -> Alcotest.fail "another fault"
   | Ok _ -> Alcotest.fail "no fault");
  let still = start m (spinning [ ints 0 0 1; Vec.zero ] (declared bodies)) in
  let next = Network.successors (standard m) still in
  Alcotest.(check bool) "turning on the tip is no contact" true (Result.is_ok next)

(* A law pushes a body into another after its step: the turn that is due then begins when they have collided. *)
let steered_into () =
  let var v = Law.Var v in
  let law = Law.Gives (Law.velocity_alone (var Vx, var Vy, Law.Sub (var Vz, Law.Mul (Const (q 40), var Dt)))) in
  let bodies = [ body "p" (0, 0, 2) ~law; body "floor" (1, 0, 0) ~fixed:true ] in
  let m = rigid (model bodies) in
  (* the edge of the floor is not under the middle of p *)
  let aside (l : State.leaf) = { l with position = vec (ratio 3 2) Rat.zero Rat.zero } in
  let s = declared bodies in
  let processes = [ s.processes.(0); State.map_leaves aside s.processes.(1) ] in
  let s = start m (State.make ~processes ~step:None ~time:None) in
  let s = take m s "time(1)" in
  check_labels "steered into the floor" [ "bounce(p, floor)" ] m s;
  Alcotest.(check bool) "its turn is due" true (Turn.due s.processes.(0));
  let s = take m s "bounce(p, floor)" in
  let p = s.processes.(0) in
  Alcotest.(check bool) "it spins fast" true (Rat.compare (Vec.norm2 p.spin) (q 1) > 0);
  check_rat "in short turns" (Rat.to_string (Turn.length m p.spin)) (Option.get p.lasts);
  check_rat "within a whole step" "1" (Option.get s.step).remaining

(* What collides at the instant at which its turn has begun has no turn any more, as if it had gone on for a
   while. *)
let just_begun () =
  let bodies = [ body "p" (0, 0, 0); body "q" (2, 0, 0) ~velocity:(-1, 0, 0); body "r" (0, 9, 0) ] in
  let m = rigid (model bodies) in
  let s = spinning [ ints 0 0 1; Vec.zero; ints 0 0 1 ] (declared bodies) in
  let begun = List.map (Turn.begun m) (Array.to_list s.processes) in
  let s = State.make ~processes:begun ~step:None ~time:None in
  let semantics = standard m in
  let after = Turning.at_contact semantics.setting ~colliding:(Collisions.colliding semantics) s in
  let going (p : State.process) = Turn.spinning p && not (Turn.due p) in
  let goes_on (s : State.t) = List.map going (Array.to_list s.processes) in
  Alcotest.(check (list bool)) "before" [ true; false; true ] (goes_on s);
  Alcotest.(check (list bool)) "then" [ false; false; true ] (goes_on after);
  Alcotest.(check bool) "a turn of it is due" true (Turn.due after.processes.(0));
  check_rat "and began now" "0" after.processes.(0).since

(* The turn of p began 1/3 ago, that of q 1/5 ago: the instants of the grid are those of q. *)
let grid_of_the_last_turn () =
  let bodies = [ body "p" (0, 0, 0); body "q" (4, 0, 0) ~velocity:(-4, 0, 0) ] in
  let turn since p = State.with_turn ~spin:(Vec.of_ints 0 0 1) ~since ~lasts:(Some (q 1)) p in
  let processes = Array.map2 turn [| ratio 1 3; ratio 1 5 |] (declared bodies).processes in
  match Collisions.first_time_of_contact (standard (rigid (model bodies))) processes ~limit:(Some (q 1)) with
  | None -> Alcotest.fail "they meet"
  | Some t ->
    let since_the_turn = Z.to_int (Q.den (Rat.add t (ratio 1 5))) in
    Alcotest.(check int) "a power of two" 0 (since_the_turn land Int.pred since_the_turn)

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("turn",
   [
     ( "turn",
       [
         case "the length of a turn" length; case "time on a body that turns" pass;
         case "a new turn" renew;
         case "half-way through a turn" midway; case "pieces of what turned" piece;
         case "turns of its own" own_turns; case "whoever stops time" bystander;
         case "steered into a contact" steered_into; case "a turn that has just begun" just_begun;
       ] );
     ( "cast",
       [
         case "parts off their centres" off_centre; case "rounded down" thirds;
         case "the last turn" grid_of_the_last_turn;
       ] );
     ( "meeting",
       [
         case "mirror images" mirror; case "bound to a fixed body" fixed_bind;
         case "face to face as without turns" translational; case "persistent contact" persistent;
       ] );
   ])
