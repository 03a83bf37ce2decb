(* Rule Draw: velocities that laws leave to chance. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Fixture

let const n = Law.Const (q n)
let still (x, y, z) = (const x, const y, const z)
let choose kicks =
  let kick (v, weight) = { Law.motion = Law.velocity_alone (still v); weight = Const weight } in
  Law.Choose (List.map kick kicks)
let network ?timestep bodies =
  let m = model ?timestep bodies in
  (m, start m (declared bodies))

let check_labels what expected m s = Alcotest.(check (list string)) what expected (labels m (successors m s))
let check_velocity what expected s leaf = Alcotest.(check string) what expected (velocity s leaf)

let chances m s =
  List.fold_left (fun sum (t : Transition.t) -> Rat.add sum (Transition.chance t.label)) Rat.zero (successors m s)

let check_sum what m s = Alcotest.(check string) what "1" (Rat.to_string (chances m s))

let two_ways = choose [ ((1, 0, 0), q 2); ((-1, 0, 0), q 1) ]

let one_walker () =
  let m, s = network [ body "p" (0, 0, 0) ~law:two_ways ] in
  let both = [ "draw(p, (-1, 0, 0)) chance(1/3)"; "draw(p, (1, 0, 0)) chance(2/3)" ] in
  check_labels "before time passes, each with its share" both m s;
  check_sum "which sum to 1" m s;
  Alcotest.(check bool) "something is to come" false (Network.quiescent (standard m) s);
  Alcotest.(check bool) "and time cannot pass" true (Network.wait (standard m) s (ratio 1 2) = Ok None);
  let s = take m s "draw(p, (1, 0, 0)) chance(2/3)" in
  check_velocity "what it drew" "(1, 0, 0)" s 0;
  check_labels "for a step" [ "time(1)" ] m s;
  check_labels "and again" both m (take m s "time(1)")

(* Named twice, named with weight 0, and by an expression that could not be evaluated if it were asked. *)
let shares () =
  let kick velocity weight = { Law.motion = Law.velocity_alone velocity; weight } in
  let law =
    Law.Choose
      [
        kick (still (0, 1, 0)) (Const (ratio 1 2));
        kick (still (5, 0, 0)) (const 0);
        kick (Law.Div (const 1, const 0), const 0, const 0) (Sub (Var Mass, const 3));
        kick (Law.Add (Var Vx, const 1), Var Vy, Var Vz) (Mul (Var Mass, Var X));
        kick (still (0, 1, 0)) (const 1);
      ]
  in
  let m, s = network [ body "p" (2, 0, 0) ~velocity:(-1, 1, 0) ~mass:3 ~law ] in
  check_labels "one velocity, all ways to it" [ "draw(p, (0, 1, 0)) chance(1)" ] m s;
  let m, s = network [ body "p" (2, 0, 0) ~velocity:(3, 0, 0) ~mass:3 ~law ] in
  check_labels "relative, by weights that are expressions"
    [ "draw(p, (0, 1, 0)) chance(1/5)"; "draw(p, (4, 0, 0)) chance(4/5)" ]
    m s

(* q is left of p, though it is declared after it. What holds of the velocities of all changes at once. *)
let in_order () =
  let falls = Law.Gives (Law.velocity_alone (Law.Var Vx, Law.Var Vy, Law.Sub (Var Vz, const 1))) in
  let bodies =
    [
      body "p" (9, 0, 0) ~velocity:(0, 1, 0) ~law:two_ways; body "q" (0, 0, 0) ~velocity:(0, 2, 0) ~law:two_ways;
      body "r" (0, 9, 0) ~law:falls; body "s" (0, 0, 9) ~velocity:(0, 3, 0);
    ]
  in
  let m, s = network bodies in
  let of_q = [ "draw(q, (-1, 0, 0)) chance(1/3)"; "draw(q, (1, 0, 0)) chance(2/3)" ] in
  check_labels "who is first by place" of_q m s;
  let s = take m s "draw(q, (1, 0, 0)) chance(2/3)" in
  List.iteri
    (fun i v -> check_velocity "nothing has changed yet" v s i)
    [ "(0, 1, 0)"; "(0, 2, 0)"; "(0, 0, 0)"; "(0, 3, 0)" ];
  check_labels "then the other" [ "draw(p, (-1, 0, 0)) chance(1/3)"; "draw(p, (1, 0, 0)) chance(2/3)" ] m s;
  Alcotest.(check bool) "a state like others" true (Well_formed.check (standard m) s = []);
  let s = take m s "draw(p, (-1, 0, 0)) chance(1/3)" in
  List.iteri
    (fun i v -> check_velocity "all velocities at once" v s i)
    [ "(-1, 0, 0)"; "(1, 0, 0)"; "(0, 0, -1)"; "(0, 3, 0)" ];
  check_labels "then time passes" [ "time(1)" ] m s

(* Of masses 1 and 3, bound: the one goes by 4 or -4 along x, the other by 4 or not. *)
let compounds () =
  let bodies =
    [
      body "p" (0, 0, 0) ~law:(choose [ ((4, 0, 0), q 1); ((-4, 0, 0), q 1) ]);
      body "q" (2, 0, 0) ~mass:3 ~law:(choose [ ((4, 0, 0), q 1); ((0, 0, 0), q 3) ]);
    ]
  in
  let m = model bodies in
  let s = start m (joined bodies [ ("a", (0, "right"), (1, "left")) ]) in
  check_labels "the mean, weighted by mass"
    [
      "draw(p, (-1, 0, 0)) chance(3/8)"; "draw(p, (1, 0, 0)) chance(3/8)"; "draw(p, (2, 0, 0)) chance(1/8)";
      "draw(p, (4, 0, 0)) chance(1/8)";
    ]
    m s;
  check_sum "which sum to 1" m s;
  (* ten beads in a row, each kicked to the left or to the right: 11 velocities, and not 1024 ways *)
  let law = choose [ ((1, 0, 0), q 1); ((-1, 0, 0), q 1) ] in
  let beads = List.init 10 (fun i -> body (Printf.sprintf "b%d" i) (2 * i, 0, 0) ~law) in
  let m = model beads in
  let bond i = ("a", (i, "right"), (Int.add i 1, "left")) in
  let s = start m (joined beads (List.init 9 bond)) in
  let all = labels m (successors m s) in
  Alcotest.(check int) "as many as the lattice has" 11 (List.length all);
  Alcotest.(check string) "binomially" "draw(b0, (-1/5, 0, 0)) chance(105/512)" (List.nth all 4);
  check_sum "which sum to 1" m s

(* A whole with a fixed leaf is not steered; a leaf that goes straight on changes nothing of its own. *)
let held () =
  let bodies = [ body "p" (0, 0, 0) ~law:two_ways; body "w" (2, 0, 0) ~fixed:true ] in
  let m = model bodies in
  let s = start m (joined bodies [ ("a", (0, "right"), (1, "left")) ]) in
  check_labels "nothing to draw" [] m s;
  let bodies = [ body "p" (0, 0, 0) ~law:two_ways; body "w" (2, 0, 0) ] in
  let m = model bodies in
  let s = start m (joined ~velocity:(0, 0, 2) bodies [ ("a", (0, "right"), (1, "left")) ]) in
  check_labels "the mean of a change and none"
    [ "draw(p, (-1/2, 0, 1)) chance(1/3)"; "draw(p, (1/2, 0, 1)) chance(2/3)" ]
    m s

let weights_that_cannot_be () =
  let faulty law expected =
    let bodies = [ body "p" (0, 0, 0) ~law ] in
    let m = model bodies in
    match Network.initial (standard m) (declared bodies) with
    | Ok _ -> Alcotest.failf "no error: %s" expected
    | Error fault ->
      Alcotest.(check string) "the fault is named" ("the law of motion of p cannot be evaluated: " ^ expected)
        (Transition.diagnostic m fault).message
  in
  faulty (choose [ ((1, 0, 0), q 1); ((0, 0, 0), q (-1)) ]) "a weight is negative";
  faulty (choose [ ((1, 0, 0), q 0); ((0, 0, 0), q 0) ]) "the weights of all its velocities are 0"

(* Each axis in primes of its own: no two ways lead to one velocity. *)
let too_many () =
  let law i =
    let far k = Q.make (Z.pow (Z.of_int 7) (Int.add (Int.mul 10 i) k)) Z.one in
    let kick k = { Law.motion = Law.velocity_alone (Law.Const (far k), const 0, const 0); weight = const 1 } in
    Law.Choose (List.init 10 kick)
  in
  let beads = List.init 8 (fun i -> body (Printf.sprintf "b%d" i) (2 * i, 0, 0) ~law:(law i)) in
  let m = model beads in
  let bond i = ("a", (i, "right"), (Int.add i 1, "left")) in
  match Network.initial (standard m) (joined beads (List.init 7 bond)) with
  | Ok _ -> Alcotest.fail "100 000 000 ways"
  | Error fault ->
    Alcotest.(check string) "the fault is named"
      "the law of motion of b6 cannot be evaluated: a whole draws among more than 1000000 velocities"
      (Transition.diagnostic m fault).message

(* Where steps are those of single processes, those draw whose steps are over. q hits a wall in the middle of its
   step. *)
let own_steps () =
  let right = choose [ ((4, 0, 0), q 1); ((2, 0, 0), q 1) ] in
  let bodies =
    [ body "p" (0, 9, 0) ~law:two_ways; body "q" (0, 0, 0) ~law:right; body "w" (4, 0, 0) ~fixed:true ]
  in
  let m = { (model bodies) with steps = Own } in
  let s = start m (declared bodies) in
  let s = take m s "draw(q, (4, 0, 0)) chance(1/2)" in
  let s = take m s "draw(p, (1, 0, 0)) chance(2/3)" in
  let s = take m s "time(1/2)" in
  let s = take m s "bounce(q, w)" in
  check_labels "q alone draws" [ "draw(q, (2, 0, 0)) chance(1/2)"; "draw(q, (4, 0, 0)) chance(1/2)" ] m s;
  check_velocity "p goes on" "(1, 0, 0)" s 0;
  Alcotest.(check bool) "a state like others" true (Well_formed.check (standard m) s = [])

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("draws",
   [
     ( "Draw",
       [
         case "Draw: one walker" one_walker;
         case "Draw: shares" shares;
         case "Draw: one after the other, all at once" in_order;
         case "Draw: compounds" compounds;
         case "Draw: what is held" held;
         case "Draw: weights that cannot be" weights_that_cannot_be;
         case "Draw: too many ways" too_many;
         case "Draw: steps of single processes (I-31)" own_steps;
       ] );
   ])
