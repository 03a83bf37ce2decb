(* Small networks of the rigid calculus, made by hand. *)

open Scc_exact
open Scc_calculus
open Fixture

let third a = ratio a 3
let vec x y z = Vec.make x y z
let ints = Vec.of_ints
let quaternion w x y z = Quaternion.make (Z.of_int w) (Z.of_int x) (Z.of_int y) (Z.of_int z)

let rigid ?(dynamics = Model.Constant_spin) ?rounding ?(resolution = ratio 1 1024) (m : Model.t) : Model.t =
  {
    m with
    rigid = Some { dynamics; resolution; round_orientation = rounding };
    round_velocity = rounding;
    lots = false;
  }

(* A plank of sides 2, 1 and 1/2 instead of the cube: no two of its moments of inertia are equal. *)
let planks (m : Model.t) =
  let solid = Scc_test_networks.Random_rigid.plank ~id:7 in
  let part (p : Model.part) = { p with solid } in
  { m with leaves = Array.map (fun (l : Model.leaf) -> { l with parts = Array.map part l.parts }) m.leaves }

(* Each process gets its spin. *)
let spinning spins (s : State.t) =
  let processes =
    List.map2 (fun spin p -> State.with_turn ~spin ~since:Rat.zero ~lasts:None p) spins (Array.to_list s.processes)
  in
  State.make ~processes ~step:s.step ~time:s.time

let moving velocities (s : State.t) =
  State.make
    ~processes:(List.map2 State.with_velocity velocities (Array.to_list s.processes))
    ~step:s.step ~time:s.time

let turned_by quaternions (s : State.t) =
  let turn q = State.map_leaves (fun l -> { l with State.turned = q }) in
  State.make ~processes:(List.map2 turn quaternions (Array.to_list s.processes)) ~step:s.step ~time:s.time

let check_rat what expected x = Alcotest.(check string) what expected (Rat.to_string x)
let check_vec what expected v = Alcotest.(check string) what expected (Vec.to_string v)
let check_turned what expected q = Alcotest.(check string) what expected (Quaternion.to_string q)
