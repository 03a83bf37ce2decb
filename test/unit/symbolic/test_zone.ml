(* A zone is in another if each of its states is, those on borders too. *)

open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_state_sets
open Scc_symbolic

let zone constraint_ : Zone.t =
  {
    skeleton = State.make ~processes:[] ~step:None ~time:None;
    halted = false;
    arrived = [];
    set = Polyhedron.of_constraints 1 [ constraint_ ];
    parameters = [| Linear.variable 1 0 |];
    time = None;
    step = None;
    grid = None;
    ages = [||];
    clocks = [||];
    places = [||];
    basis = [| 0 |];
  }

let x = Linear.variable 1 0
let zero = Linear.constant 1 Rat.zero
let open_ = zone (Constraint.greater x zero)
let closed = zone (Constraint.at_least x zero)
let check name expected a b = Alcotest.(check bool) name expected (Zone_form.included a b <> None)

let borders () =
  check "an open one in a closed one" true open_ closed;
  check "a closed one in an open one" false closed open_;
  check "a closed one in itself" true closed closed

(* The same line of states, (t, 2 t): told by its first number, and by its second. *)
let by_first constraint_ : Zone.t =
  { (zone constraint_) with parameters = [| x; Linear.scale (Rat.of_int 2) x |] }

let by_second constraint_ : Zone.t =
  { (zone constraint_) with parameters = [| Linear.scale (Rat.div Rat.one (Rat.of_int 2)) x; x |]; basis = [| 1 |]
  }

let other_forms () =
  let least = Constraint.at_least x and greater = Constraint.greater x in
  let one = Linear.constant 1 Rat.one and two = Linear.constant 1 (Rat.of_int 2) in
  check "an open one in a closed one" true (by_first (greater one)) (by_second (least two));
  check "a closed one in an open one" false (by_first (least one)) (by_second (greater two));
  check "a closed one in a closed one" true (by_first (least one)) (by_second (least two));
  check "the half of one" false (by_first (least one)) (by_second (least (Linear.constant 1 (Rat.of_int 3))));
  check "of another line" false
    { (by_first (least one)) with parameters = [| x; x |] }
    (by_second (least (Linear.constant 1 Rat.zero)))

let kinds () =
  let same name expected b = Alcotest.(check bool) name expected (Zone_form.same_kind closed b) in
  same "other numbers" true open_;
  same "halted" false { closed with halted = true };
  same "after an event" false { closed with arrived = [ 0 ] }

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("zone", [ ("comparing", [ case "borders" borders; case "borders of other forms" other_forms; case
                               "kinds" kinds ]) ])
