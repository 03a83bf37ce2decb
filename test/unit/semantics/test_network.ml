(* Rules Time, Bind, Bounce and Steer on small networks of cubes. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Fixture

let standard = Scc_engine.Standard.of_model

let network ?definitions ?timestep ?splits bodies =
  let m = model ?definitions ?timestep ?splits bodies in
  (m, start m (declared bodies))

let check_velocity what expected s leaf = Alcotest.(check string) what expected (velocity s leaf)

let time () =
  let m, s = network [ body "p" (0, 0, 0) ~velocity:(1, 0, 0); body "q" (5, 0, 0) ] in
  check_labels "time passes to the first contact" [ "time(3)" ] m s;
  let m, s = network [ body "p" (0, 0, 0) ~velocity:(1, 0, 0) ~behaviour:(eps (q 2) nil); body "q" (5, 0, 0) ] in
  check_labels "or to the horizon" [ "time(2)" ] m s;
  let s = take m s "time(2)" in
  check_labels "and on from there" [ "time(1)" ] m s

let grazing () =
  let m, s = network [ body "p" (0, 0, 0) ~velocity:(1, 0, 0); body "q" (5, 2, 0) ] in
  check_labels "sliding along is no collision" [] m s;
  Alcotest.(check bool) "the network is quiescent" true (Network.quiescent (standard m) s);
  let m, s = network [ body "p" (0, 0, 0); body "q" (2, 0, 0) ] in
  check_labels "nor is rest" [] m s

let bounce () =
  let m, s = network [ body "p" (0, 0, 0) ~velocity:(3, 1, 0); body "q" (2, 0, 0) ~velocity:(-1, 0, 0) ] in
  check_labels "incompatible bodies bounce" [ "bounce(p, q)" ] m s;
  let s = take m s "bounce(p, q)" in
  check_velocity "equal masses swap the normal part" "(-1, 1, 0)" s 0;
  check_velocity "and keep the tangential" "(3, 0, 0)" s 1;
  let m, s = network [ body "p" (0, 0, 0) ~velocity:(3, 0, 0) ~mass:2; body "q" (2, 0, 0) ] in
  let s = take m s "bounce(p, q)" in
  check_velocity "the heavier goes on" "(1, 0, 0)" s 0;
  check_velocity "the lighter is thrown" "(4, 0, 0)" s 1

(* q is hit by 1 below its centre. *)
let off_centre () =
  let m, s = network [ body "p" (0, 0, 0) ~velocity:(1, 0, 0); body "q" (2, 0, 1) ] in
  let angular (s : State.t) =
    Array.fold_left
      (fun sum (p : State.process) ->
         match State.mass m p with
         | Some mass -> Vec.add sum (Vec.cross (State.centre_of_mass m p) (Vec.scale mass p.velocity))
         | None -> sum)
      Vec.zero s.processes
  in
  let after = take m s "bounce(p, q)" in
  check_velocity "the velocity is handed on" "(1, 0, 0)" after 1;
  Alcotest.(check string) "angular momentum comes from nowhere" "(0, 1, 0)"
    (Vec.to_string (Vec.sub (angular after) (angular s)))

let wall () =
  let m, s = network [ body "p" (0, 0, 0) ~velocity:(3, 1, 2); body "w" (2, 0, 0) ~fixed:true ] in
  let s = take m s "bounce(p, w)" in
  check_velocity "a fixed body reflects" "(-3, 1, 2)" s 0;
  check_velocity "and stays" "(0, 0, 0)" s 1

let clash b1 b2 =
  network
    [
      body "p" (0, 0, 0) ~velocity:(2, 0, 0) ~mass:2 ~behaviour:b1;
      body "q" (2, 1, 0) ~velocity:(-1, 3, 0) ~behaviour:b2;
    ]

let bind () =
  let m, s = clash (open_ "a" [ "right" ] nil) (co_open "a" [ "left" ] nil) in
  check_labels "a compatible collision binds" [ "bind(a, p.right, q.left)" ] m s;
  let s = take m s "bind(a, p.right, q.left)" in
  Alcotest.(check int) "into one process" 1 (Array.length s.processes);
  check_velocity "that keeps the momentum" "(1, 1, 0)" s 0;
  check_labels "and never collides with itself" [] m s

let incompatible () =
  let bounces what b1 b2 =
    let m, s = clash b1 b2 in
    check_labels what [ "bounce(p, q)" ] m s
  in
  bounces "two names" (open_ "a" [ "right" ] nil) (open_ "a" [ "left" ] nil);
  bounces "other names" (open_ "a" [ "right" ] nil) (co_open "b" [ "left" ] nil);
  bounces "other places" (open_ "a" [ "left" ] nil) (co_open "a" [ "left" ] nil);
  bounces "closed for now" (eps (q 1) (open_ "a" [ "right" ] nil)) (co_open "a" [ "left" ] nil)

let lower_dimension () =
  (* The channel of p is active on its top face, whose closure holds the upper edge of the right face: it
     touches the left face of q, which lies higher. *)
  let m, s =
    network
      [
        body "p" (0, 0, 0) ~velocity:(2, 0, 0) ~behaviour:(open_ "a" [ "top" ] nil);
        body "q" (2, 1, 1) ~behaviour:(co_open "a" [ "left" ] nil);
      ]
  in
  check_labels "the highest pair among those shared" [ "bind(a, p.[f,g], q.left)" ] m s

let choice () =
  let m, s =
    clash
      (open_ "a" [ "right" ] nil + open_ "b" [ "right" ] nil)
      (co_open "a" [ "left" ] nil + co_open "b" [ "left" ] nil)
  in
  check_labels "one transition for each candidate"
    [ "bind(a, p.right, q.left)"; "bind(b, p.right, q.left)" ]
    m s;
  let m, s = clash (open_ "a" [ "right" ] nil + open_ "a" [ "right" ] (eps (q 1) nil))
      (co_open "a" [ "left" ] nil) in
  check_labels "summands with other continuations are other choices"
    [ "bind(a, p.right, q.left)"; "bind(a, p.right, q.left)" ]
    m s

let every_order () =
  let m, s =
    network
      [
        body "p" (0, 0, 0); body "q" (-2, 0, 0) ~velocity:(1, 0, 0); body "r" (2, 0, 0) ~velocity:(-1, 0, 0);
      ]
  in
  check_labels "simultaneous collisions, in every order (I-8)" [ "bounce(p, q)"; "bounce(p, r)" ] m s;
  let s = take m s "bounce(p, q)" in
  check_labels "each followed by a fresh look" [ "bounce(p, r)" ] m s

let fixed_bind () =
  let m, s =
    network
      [
        body "p" (0, 0, 0) ~velocity:(2, 0, 0) ~behaviour:(open_ "a" [ "right" ] nil);
        body "w" (2, 0, 0) ~fixed:true ~behaviour:(co_open "a" [ "left" ] nil);
      ]
  in
  let s = take m s "bind(a, p.right, w.left)" in
  check_velocity "what binds to a fixed body stops" "(0, 0, 0)" s 0

let var v = Law.Var v

let falling =
  Law.Gives (Law.velocity_alone (var Vx, var Vy, Law.Sub (var Vz, Law.Mul (Const (q 10), var Dt))))

let steer () =
  let m, s = network ~timestep:(ratio 1 2) [ body "p" (0, 0, 100) ~law:falling ] in
  check_velocity "at the start dt = 0 (I-10)" "(0, 0, 0)" s 0;
  let s = take m s "time(1/2)" in
  check_velocity "then once a step" "(0, 0, -5)" s 0;
  let s = take m s "time(1/2)" in
  check_velocity "and again" "(0, 0, -10)" s 0

let steer_after_collision () =
  (* The floor's top is at z = 1: p falls at 10 from z = 5 and hits it after 3/10 of a step of 1. *)
  let bodies =
    [ body "p" (0, 0, 5) ~velocity:(0, 0, -10) ~law:falling; body "floor" (0, 0, 0) ~fixed:true ]
  in
  let m, s = network bodies in
  let s = take m s "time(3/10)" in
  let s = take m s "bounce(p, floor)" in
  check_velocity "the step is cut short and the law gets what has passed (I-10)" "(0, 0, 7)" s 0;
  check_labels "a new step begins" [ "time(1)" ] m s

let steer_once () =
  (* Gravity pulls a resting cube into the floor: it bounces, and is not steered again at this instant. *)
  let bodies = [ body "p" (0, 0, 2) ~law:falling; body "floor" (0, 0, 0) ~fixed:true ] in
  let m, s = network bodies in
  let s = take m s "time(1)" in
  check_velocity "steered into the floor" "(0, 0, -10)" s 0;
  let s = take m s "bounce(p, floor)" in
  check_velocity "and thrown back, once" "(0, 0, 10)" s 0;
  check_labels "time passes" [ "time(1)" ] m s

let steer_on_the_beat () =
  (* As above, but that a bounce leaves the step and the velocity as they are: 7/10 of the step remain. *)
  let bodies =
    [ body "p" (0, 0, 5) ~velocity:(0, 0, -10) ~law:falling; body "floor" (0, 0, 0) ~fixed:true ]
  in
  let m = { (model bodies) with steps = Steady } in
  let s = start m (declared bodies) in
  let s = take m s "time(3/10)" in
  let s = take m s "bounce(p, floor)" in
  check_velocity "thrown back" "(0, 0, 10)" s 0;
  check_labels "the step goes on" [ "time(7/10)" ] m s;
  let s = take m s "time(7/10)" in
  check_velocity "steered at the beat, with dt = 1" "(0, 0, 0)" s 0;
  (* 7 above the floor for a whole step, then falling at 10: it comes when it came before *)
  let s = take m (take m (take m s "time(1)") "time(7/10)") "bounce(p, floor)" in
  check_labels "of the same step 3/10 remain" [ "time(3/10)" ] m s

let bad_law () =
  let law = Law.Gives (Law.velocity_alone (Law.Div (Const (q 1), var Dt), Const (q 0), Const (q 0))) in
  let bodies = [ body "p" (0, 0, 0) ~law ] in
  let m = model bodies in
  match Network.initial (standard m) (declared bodies) with
  | Ok _ -> Alcotest.fail "1/dt was evaluated at dt = 0"
  | Error fault ->
    Alcotest.(check string) "the fault is named" "the law of motion of p cannot be evaluated: it divides by zero"
      (Transition.diagnostic m fault).message

let zeno () =
  let wall name x = body name (x, 0, 0) ~fixed:true in
  let bodies = [ body "p" (0, 0, 0) ~velocity:(1, 0, 0); wall "w" (-2); wall "v" 2 ] in
  let m, s = network bodies in
  let s' = take m s "bounce(p, v)" in
  let s'' = take m s' "bounce(p, w)" in
  Alcotest.(check bool) "a plate that fills its slot rattles in no time" true (State.equal s s'')

(* Steps of single processes: p and q are in steps of their own. When they are bound at 3/4 the laws of both are
   asked, each with the dt of its own last update: 1 and 3/4, of masses 1 and 3. *)
let own_steps () =
  let var v = Law.Var v in
  let law = Law.Gives (Law.velocity_alone (var Vx, var Vy, Law.Sub (var Vz, var Dt))) in
  let bodies =
    [
      body "p" (0, 0, 0) ~law ~behaviour:(open_ "a" [ "right" ] nil);
      body "q" (8, 0, 0) ~velocity:(-8, 0, 0) ~mass:3 ~law ~behaviour:(co_open "a" [ "left" ] nil);
      body "w" (11, 0, 0) ~fixed:true;
    ]
  in
  let m = { (model bodies) with steps = Own } in
  (* q begins a step a quarter later than p, as if something had hit it then *)
  let late (s : State.t) =
    let waited l = { l with State.waited = ratio 1 4 } in
    let p = State.map_leaves waited s.processes.(0) |> State.with_phase (Some State.Moving) in
    State.make ~processes:[ p; s.processes.(1); s.processes.(2) ] ~step:None ~time:None
  in
  let s = start m (declared bodies) in
  Alcotest.(check bool) "no step of all" true (Option.is_none s.step);
  let phase i (s : State.t) = Option.map (fun f -> f = State.Steered) s.processes.(i).phase in
  Alcotest.(check (list (option bool))) "steered, but for the wall" [ Some true; Some true; None ]
    (List.map (fun i -> phase i s) [ 0; 1; 2 ]);
  let s = late s in
  check_labels "its step ends first" [ "time(3/4)" ] m s;
  let meeting = take m s "time(3/4)" in
  check_velocity "not before they have collided" "(0, 0, 0)" meeting 0;
  check_labels "q comes" [ "bind(a, p.right, q.left)" ] m meeting;
  let bound = take m meeting "bind(a, p.right, q.left)" in
  (* (0 - 1 + 3 (0 - 3/4)) / 4 *)
  check_velocity "each with its own dt" "(-6, 0, -13/16)" bound 0;
  Alcotest.(check bool) "well-formed" true (Well_formed.check (standard m) bound = [])

let names m (s : State.t) =
  let leaves = List.concat_map (fun (p : State.process) -> Array.to_list p.leaves) (Array.to_list s.processes) in
  List.map (fun (l : State.leaf) -> m.Model.leaves.(l.leaf).name) leaves

let check_names what expected m s = Alcotest.(check (list string)) what expected (names m s)

let absorb () =
  let drain = body "drain" (4, 0, 0) ~fixed:true ~absorbs:true in
  let m, s = network [ body "p" (0, 0, 0) ~velocity:(3, 1, 0); body "q" (0, 9, 0) ~velocity:(0, 1, 0); drain ] in
  check_labels "it comes" [ "time(2/3)" ] m s;
  let s = take m s "time(2/3)" in
  check_labels "and is taken, and does not bounce" [ "absorb(p, drain)" ] m s;
  let s = take m s "absorb(p, drain)" in
  check_names "the others stay" [ "q"; "drain" ] m s;
  check_velocity "as they are" "(0, 1, 0)" s 1;
  Alcotest.(check bool) "well-formed" true (Well_formed.check (standard m) s = []);
  check_labels "nothing comes of it" [] m s;
  let m, s = network [ body "p" (2, 3, 0) ~velocity:(0, -1, 0); drain ] in
  check_labels "sliding along it is no collision" [] m s;
  let m = { m with Model.binding = On_contact } in
  check_labels "nor with binding by contact" [] m (start m s);
  (* the whole process goes, also where another part of it hits *)
  let open_ name face = Behaviour.open_ name (channel "a" [ face ]) nil in
  let m, s =
    network
      [
        body "p" (0, 0, 0) ~velocity:(1, 0, 0) ~behaviour:(open_ Name "right");
        body "q" (2, 0, 0) ~behaviour:(open_ Co_name "left");
        body "drain" (5, 0, 0) ~fixed:true ~absorbs:true;
      ]
  in
  let s = take m s "bind(a, p.right, q.left)" in
  let s = take m s "time(2)" in
  check_labels "named by its first leaf" [ "absorb(p, drain)" ] m s;
  check_names "both are gone" [ "drain" ] m (take m s "absorb(p, drain)")

let absorb_beside () =
  let bodies =
    [
      body "p" (0, 0, 0) ~velocity:(1, 0, 0);
      body "drain" (2, 1, 0) ~fixed:true ~absorbs:true;
      body "wall" (2, -1, 0) ~fixed:true;
      body "q" (0, 2, 0) ~velocity:(1, 0, 0);
    ]
  in
  let m, s = network bodies in
  check_labels "in turn, in every order" [ "absorb(p, drain)"; "bounce(p, wall)"; "absorb(q, drain)" ] m s;
  check_labels "what has bounced does not come again" [ "absorb(q, drain)" ] m (take m s "bounce(p, wall)");
  check_labels "two go one by one" [ "absorb(p, drain)"; "bounce(p, wall)" ] m (take m s "absorb(q, drain)");
  let m = { m with Model.collisions = Together } in
  check_labels "together, who may be taken never bounces" [ "absorb(p, drain)"; "absorb(q, drain)" ] m s

(* p and q run into a wall from two sides. *)
let wall_between () =
  let bodies =
    [
      body "p" (-3, 0, 0) ~velocity:(1, 0, 0); body "q" (3, 0, 0) ~velocity:(-1, 0, 0);
      body "wall" (0, 0, 0) ~fixed:true;
    ]
  in
  let m, s = network bodies in
  let m = { m with Model.collisions = Together } in
  check_labels "a fixed body joins no cluster" [ "bounce(p, wall)"; "bounce(q, wall)" ] m (take m s "time(1)")

(* p runs into two drains and into q, which rests; what q and p offer each other may bind them instead. *)
let absorb_in_cluster () =
  let all behaviour other =
    let bodies =
      [
        body "p" (0, 0, 0) ~velocity:(1, 1, 1) ~behaviour; body "q" (2, 1, 0) ~behaviour:other;
        body "drain" (0, 2, 0) ~fixed:true ~absorbs:true; body "sink" (0, 0, 2) ~fixed:true ~absorbs:true;
      ]
    in
    let m, s = network bodies in
    ({ m with Model.collisions = Together }, s)
  in
  let m, s = all nil nil in
  check_labels "in turn" [ "bounce(p, q)"; "absorb(p, drain)"; "absorb(p, sink)" ]
    { m with Model.collisions = In_turn } s;
  check_labels "no bounce of the cluster" [ "absorb(p, drain)"; "absorb(p, sink)" ] m s;
  check_names "q stays as it is" [ "q"; "drain"; "sink" ] m (take m s "absorb(p, drain)");
  check_velocity "at rest" "(0, 0, 0)" (take m s "absorb(p, drain)") 1;
  let m, s = all (open_ "a" [ "right" ] nil) (co_open "a" [ "left" ] nil) in
  let bind = "bind(a, p.right, q.left)" in
  check_labels "a binding is possible as well" [ bind; "absorb(p, drain)"; "absorb(p, sink)" ] m s;
  check_labels "and what is bound is looked at afresh" [ "absorb(p, drain)"; "absorb(p, sink)" ] m (take m s bind)

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("network",
   [
     ( "rules",
       [
         case "Time: to the next event" time;
         case "Time: grazing and resting contact is no collision" grazing;
         case "Bounce: two bodies" bounce;
         case "Response: off-centre hits keep no angular momentum" off_centre;
         case "Bounce: a fixed body" wall;
         case "Absorb: what hits it is gone" absorb;
         case "Absorb: beside other collisions" absorb_beside;
         case "Absorb: in a cluster (I-32)" absorb_in_cluster;
         case "Bounce: a wall between two (I-32)" wall_between;
         case "Bind: a compatible collision" bind;
         case "Bind: what is not compatible bounces" incompatible;
         case "Bind: the touching pairs of the highest dimension (I-12)" lower_dimension;
         case "Bind: one transition for each candidate" choice;
         case "Bind: to a fixed body" fixed_bind;
         case "Time: simultaneous collisions (I-8)" every_order;
         case "Steer: once a step" steer;
         case "Steer: steps of single processes (I-31)" own_steps;
         case "Steer: after a collision (I-10)" steer_after_collision;
         case "Steer: once an instant (I-15)" steer_once;
         case "Steer: steps that keep their beat (I-35)" steer_on_the_beat;
         case "Steer: a law that cannot be evaluated" bad_law;
         case "Time: Zeno" zeno;
       ] );
   ])
