(* Laws of the rule book: what commutes with the transitions of every network, of random models of both calculi, by
   random parameters. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_test_networks
module Gen = QCheck2.Gen

let standard = Scc_engine.Standard.of_model
let rational n d = Rat.make (Z.of_int n) (Z.of_int d)
let fail_on = function None -> true | Some why -> QCheck2.Test.fail_report why

(* {1 Networks in translation} *)

let states_per_network = 60

let holds symmetry (m, start) =
  fail_on (Symmetry.broken (symmetry m) m (Reach.states m start ~limit:states_per_network))

(* [symmetry] is a generator of what a model is mapped by. *)
let of_networks name ~count ~of_network networks symmetry =
  QCheck2.Test.make ~name ~count
    ~print:(fun (n, _) -> Random_network.print n)
    (Gen.pair networks symmetry)
    (fun (n, symmetry) -> holds symmetry (Random_network.start (of_network n)))

let straight name ?(count = 50) ?steered ?(of_network = Fun.id) symmetry =
  of_networks name ~count ~of_network (Random_network.generate ?steered ()) symmetry

(* With the switches that a model has. *)
let switched name ?(count = 16) ?steered ?draws ?(of_network = Fun.id) symmetry =
  of_networks name ~count ~of_network (Random_network.switched ?steered ?draws ()) symmetry

(* {1 Bodies that turn} *)

(* That nothing is ahead is proved with cubes along the axes: perhaps here and not there. *)
let comparable (symmetry : Symmetry.t) m (s, _) =
  Rigid_reach.bits s <= Rigid_reach.longest
  && Bool.equal
    (Network.quiescent (standard m) s)
    (Network.quiescent (standard (symmetry.model m)) (symmetry.state s))

let turning name ?(count = 3) ?(of_network = Fun.id) features symmetry =
  QCheck2.Test.make ~name ~count
    ~print:(fun (n, _) -> Random_rigid.print n)
    (Gen.pair (Random_rigid.generate features) symmetry)
    (fun (n, symmetry) ->
       let m, states = Rigid_reach.reached (of_network n) in
       let symmetry = symmetry m in
       fail_on (Symmetry.broken symmetry m (List.filter (comparable symmetry m) states)))

(* Where a law is said to fail, some network shows it. *)
let fails name ?(count = 4) features symmetry =
  let shows () =
    let rand = Random.State.make [| 42 |] in
    let broken (n, symmetry) =
      let m, states = Rigid_reach.reached n in
      let symmetry = symmetry m in
      Option.is_some (Symmetry.broken symmetry m (List.filter (comparable symmetry m) states))
    in
    let drawn = Gen.generate ~rand ~n:count (Gen.pair (Random_rigid.generate features) symmetry) in
    Alcotest.(check bool) "some network shows it" true (List.exists broken drawn)
  in
  Alcotest.test_case name `Quick shows

let any = Random_rigid.anything
let rounded = { any with rounds = true }
let falling = { any with laws = true; rounds = true }
let constant_spin = { any with dynamics = `Constant_spin }
let with_switches (f : Random_rigid.features) = { f with switched = true }
let free_body = { any with dynamics = `Free_body }

(* {1 What networks are mapped by} *)

let always symmetry = Gen.pure (fun _ -> symmetry)

let vector =
  let coordinate = Gen.map2 rational Gen.(-40 -- 40) Gen.(1 -- 7) in
  Gen.map3 Vec.make coordinate coordinate coordinate

let displacement = Gen.map (fun by _ -> Symmetry.translation by) vector

let quaternion =
  let c = Gen.(-3 -- 3) in
  Gen.map
    (fun (w, x, y, z) ->
       let z_of = Z.of_int in
       if w = 0 && x = 0 && y = 0 && z = 0 then Quaternion.identity
       else Quaternion.make (z_of w) (z_of x) (z_of y) (z_of z))
    (Gen.quad c c c c)

let cube_rotation = Gen.map (fun r _ -> r) (Gen.oneofl Symmetry.rotations)
let rotation = Gen.map (fun q _ -> Symmetry.any_rotation q) quaternion
let turn = Gen.map (fun q _ -> Symmetry.turning q) quaternion
let quarter_turn = always (Symmetry.turning (Quaternion.make Z.one Z.zero Z.zero Z.one))
let boost = Gen.map (fun by _ -> Symmetry.boost by) vector
let factor = Gen.map2 rational Gen.(1 -- 9) Gen.(1 -- 9)
let power_of_two = Gen.oneofl [ rational 1 2; Rat.one; rational 2 1; rational 4 1 ]

let units lengths times =
  Gen.map3 (fun length time mass _ -> Symmetry.scaling ~length ~time ~mass) lengths times factor

(* Leaves declared in another order, under other names. *)
let redeclared =
  Gen.map
    (fun keys (m : Model.t) ->
       let n = Array.length m.leaves in
       let order = List.init n (fun i -> (List.nth keys (i mod List.length keys), i)) in
       let perm = Array.make n 0 in
       List.iteri (fun place (_, i) -> perm.(i) <- place) (List.sort Stdlib.compare order);
       let symmetry = Symmetry.permutation perm in
       let rename (l : Model.leaf) =
         let other name = "other_" ^ name in
         let part (p : Model.part) = { p with name = other p.name } in
         { l with name = other l.name; parts = Array.map part l.parts }
       in
       let model m =
         let m = symmetry.model m in
         { m with Model.leaves = Array.map rename m.Model.leaves }
       in
       { symmetry with model })
    Gen.(list_repeat 8 (0 -- 1000))

(* {1 One state, written down in another way} *)

let other_way (s : State.t) =
  let backwards a = List.rev (Array.to_list a) in
  let process (p : State.process) =
    let turned_round (b : State.bond) = State.bond b.name b.two b.one in
    State.process ~leaves:(backwards p.leaves)
      ~bonds:(List.map turned_round (backwards p.bonds))
      ~velocity:p.velocity ~spin:p.spin ~since:p.since ~kept:p.kept ~clock:p.clock ()
  in
  State.make ~processes:(List.map process (backwards s.processes)) ~step:s.step ~time:s.time

let brackets =
  QCheck2.Test.make ~name:"Congruence: brackets, ends of bonds and parallel components in any order" ~count:40
    ~print:Random_network.print (Random_network.generate ()) (fun n ->
        let m, start = Random_network.start n in
        let states = Reach.states m start ~limit:states_per_network in
        List.for_all (fun (s, _) -> State.equal s (other_way s)) states)

let suite =
  let group name ?(failing = []) tests = (name, Scc_test_support.Property.cases tests @ failing) in
  ("symmetry laws",
   [
     group "Congruence"
       [
         brackets;
         straight "Congruence: bodies declared in another order, under other names" ~steered:true redeclared;
         turning "Congruence: bodies that turn" falling redeclared;
         switched "Congruence: with the switches of a model" ~steered:true redeclared;
         turning "Congruence: bodies that turn, with the switches of a model" (with_switches falling) redeclared;
       ];
     group "Displacement"
       [
         straight "Displacement: nothing depends on where the network is" ~steered:true displacement;
         turning "Displacement: bodies that turn, with laws and rounding" falling displacement;
         switched "Displacement: with the switches of a model" ~steered:true displacement;
         turning "Displacement: bodies that turn, with the switches of a model" (with_switches falling)
           displacement;
       ];
     group "Rotation"
       ~failing:
         [
           fails "Rotation: fails for free bodies that are not turned by quarters" free_body turn;
           fails "Rotation: fails with rounding" { rounded with dynamics = `Constant_spin } turn;
         ]
       [
         straight "Rotation: by the rotations of a cube" ~count:40 cube_rotation;
         straight "Rotation: by any rational rotation" rotation;
         turning "Rotation: bodies that turn, by any rational rotation" ~count:3 constant_spin turn;
         turning "Rotation: shapes that are declared in another position" ~count:3 constant_spin rotation;
         turning "Rotation: free bodies by a quarter turn" any quarter_turn;
         turning "Rotation: with rounding, by the rotations of a cube" rounded cube_rotation;
         switched "Rotation: with the switches of a model" ~draws:false rotation;
         turning "Rotation: bodies that turn, with the switches of a model" ~count:3
           (with_switches { constant_spin with draws = false }) turn;
       ];
     group "Boost" ~failing:[ fails "Boost: fails with rounding and where something is fixed" rounded boost ]
       [
         straight "Boost: nothing depends on how the whole moves" ~steered:true
           ~of_network:Random_network.all_free boost;
         turning "Boost: bodies that turn" ~of_network:Random_rigid.all_free { any with laws = true } boost;
         switched "Boost: with the switches of a model" ~steered:true ~of_network:Random_network.all_free boost;
         turning "Boost: bodies that turn, with the switches of a model" ~of_network:Random_rigid.all_free
           (with_switches { any with laws = true })
           boost;
       ];
     group "Scaling"
       ~failing:
         [
           fails "Scaling: fails for bodies that turn in other units of time" any
             (units (Gen.pure Rat.one) (Gen.pure (rational 3 1)));
           fails "Scaling: fails with rounding" rounded (units power_of_two power_of_two);
         ]
       [
         straight "Scaling: units of length, time and mass" (units factor factor);
         turning "Scaling: bodies that turn, by powers of two" any (units power_of_two power_of_two);
         switched "Scaling: with the switches of a model" ~of_network:Random_network.without_pushes
           (units factor factor);
         switched "Scaling: with pushes, by powers of two" (units power_of_two power_of_two);
         turning "Scaling: bodies that turn, with the switches of a model" (with_switches any)
           (units power_of_two power_of_two);
       ];
   ])
