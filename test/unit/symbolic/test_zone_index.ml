(* The index of zones finds what going through all of them finds; and constraints that say nothing new are told. *)

open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_state_sets
open Scc_symbolic
module Gen = QCheck2.Gen

let small = Gen.map Rat.of_int (Gen.int_range (-1) 1)
let form n = Gen.map2 (fun constant c -> Linear.make ~constant c) small (Gen.array_size (Gen.return n) small)

let constraint_of n =
  let make f k = match k with
    | 0 -> Constraint.less f (Linear.constant n Rat.zero)
    | 1 -> Constraint.equals f (Linear.constant n Rat.zero)
    | _ -> Constraint.at_most f (Linear.constant n Rat.zero)
  in
  Gen.map2 make (form n) (Gen.int_range 0 4)

(* Of a few directions, so that zones lie in others. *)
let zone : Zone.t option Gen.t =
  let of_parts forms constraints =
    let bounded = Constraint.at_most (Linear.variable 2 0) (Linear.constant 2 (Rat.of_int 3)) in
    let set = Polyhedron.of_constraints 2 (bounded :: constraints) in
    if Polyhedron.is_empty set then None
    else
      let z : Zone.t =
        {
          skeleton = State.make ~processes:[] ~step:None ~time:None;
          halted = false;
          arrived = [];
          set;
          parameters = forms;
          time = None;
          step = None;
          grid = None;
          ages = [||];
          clocks = [||];
          places = [||];
          basis = [||];
        }
      in
      Some (fst (Zone_form.canonical z))
  in
  Gen.map2 of_parts (Gen.array_size (Gen.return 3) (form 2)) (Gen.list_size (Gen.int_range 0 3) (constraint_of 2))

let zones = Gen.map (List.filter_map Fun.id) (Gen.list_size (Gen.return 40) zone)

let found_by_index index z =
  Zone_index.last_around index z (fun (i, other) -> Option.map (fun _ -> i) (Zone_form.included z other))

let last_of zones z =
  let with_all (i, other) = if Zone_form.included z other = None then None else Some i in
  List.find_map with_all zones

let in_others = ref 0

let around =
  QCheck2.Test.make ~name:"the last zone around one, by the index and among all" ~count:200 zones (fun zones ->
      let index = Zone_index.create () in
      let agrees (known, so_far) z =
        let expected = last_of known z in
        if expected <> None then incr in_others;
        let so_far = so_far && Option.equal Int.equal expected (found_by_index index z) in
        let alike = List.filter (fun (_, other) -> Zone_form.same_forms z other) known in
        let found = Zone_index.alike index z in
        let so_far = so_far && List.equal Int.equal (List.map fst alike) (List.map fst found) in
        let entry = (List.length known, z) in
        Zone_index.add index z entry;
        (entry :: known, so_far)
      in
      snd (List.fold_left agrees ([], true) zones))

let some_are () = Alcotest.(check bool) "some zones were in others" true (!in_others > 100)

let suite =
  ( "zone index",
    [
      ( "zones",
        Scc_test_support.Property.cases [ around ] @ [ Alcotest.test_case "some are in others" `Quick some_are ] );
    ] )
