(* The rules by themselves, over other geometries and other neighbours: what those who run them hand in to be fast
   changes no transition. *)

open Scc_exact
open Scc_geometry
open Scc_rigid
open Scc_calculus
open Scc_semantics
open Scc_test_networks

let same_transition (a : Transition.t) (b : Transition.t) =
  Transition.equal_label a.label b.label
  && State.equal a.target b.target
  && List.equal String.equal (List.map Rule.id a.rules) (List.map Rule.id b.rules)

let same_fault (a : Transition.fault) (b : Transition.fault) =
  match (a, b) with
  | Persistent_contact firsts, Persistent_contact firsts' -> List.equal Int.equal firsts firsts'
  | Bad_law { leaf; _ }, Bad_law { leaf = other; _ } -> leaf = other
  | Bad_chance f, Bad_chance g -> f = g
  | (Persistent_contact _ | Bad_law _ | Bad_chance _), _ -> false

(* The first states of a network breadth first, and some of those behind the limit. *)
let reached standard start ~limit =
  let rec go found = function
    | s :: rest when List.length found < limit ->
      if List.exists (State.equal s) found then go found rest
      else
        let targets =
          match Network.successors standard s with
          | Ok transitions -> List.map (fun (t : Transition.t) -> t.target) transitions
          | Error _ -> []
        in
        go (s :: found) (rest @ targets)
    | _ -> found
  in
  go [] [ start ]

let agrees ~limit other (m, start) =
  let standard = Scc_engine.Standard.of_model m in
  let other = other m in
  let same s =
    Bool.equal (Network.quiescent standard s) (Network.quiescent other s)
    && Result.equal ~ok:(List.equal same_transition) ~error:same_fault
      (Network.successors standard s) (Network.successors other s)
  in
  List.for_all same (reached standard start ~limit)

(* {1 Motion is a path} *)

(* The run that always takes the last transition, which is a passing of time where time may pass. *)
let course m start ~steps =
  let semantics = Scc_engine.Standard.of_model m in
  let rec go taken s n =
    match if n = 0 then Ok [] else Network.successors semantics s with
    | Ok (_ :: _ as transitions) ->
      let t = List.nth transitions (List.length transitions - 1) in
      go ((t.Transition.label, t.target) :: taken) t.target (n - 1)
    | Ok [] | Error _ -> List.rev taken
  in
  Scc_motion.Course.make semantics ~initial:start (go [] start steps) ~rest:Rat.zero

let same_pose (l : State.leaf) (k : State.leaf) =
  l.leaf = k.leaf && Vec.equal l.position k.position && Quaternion.equal l.turned k.turned

(* Exact numbers of bodies that turn and bounce grow with every step: few steps will do. *)
let along_its_paths ~steps (m, start) =
  let course = course m start ~steps in
  let third d = Rat.div d (Rat.of_int 3) in
  let holds (leg : Scc_motion.Course.leg) =
    let d = third (Transition.duration_of leg.label) in
    let paths = Scc_motion.Course.paths course leg.before in
    let there = Scc_motion.Course.at course (Rat.add leg.start d) in
    Rat.sign d = 0
    || Array.for_all2
      (fun path (p : State.process) ->
         Array.for_all2 same_pose (Scc_motion.Path.at path d).leaves p.leaves)
      paths there.processes
  in
  let ends = Scc_motion.Course.at course (Scc_motion.Course.duration course) in
  State.equal ends (Scc_motion.Course.last course)
  && Array.for_all holds (Scc_motion.Course.legs course)

(* {1 All separating axes in place of obstacles} *)

let naive_solid (p : Placed.t) =
  let faces = Array.to_list p.solid.polyhedron.faces in
  { Scc_naive.Naive.points = Placed.vertices p; faces = List.map (fun (_, f) -> Array.to_list f) faces }

let by_all_axes : Geometry.t =
  let fast a b = Scc_naive.Fast.make (naive_solid a) (naive_solid b) in
  let exact = Geometry.exact ~obstacle:(fun a b -> Obstacle.make a b) in
  {
    exact with
    relation =
      (fun a b ->
         match Scc_naive.Fast.relation (fast a b) Vec.zero with
         | Apart -> Apart
         | Touching -> Touching
         | Interpenetrating -> Interpenetrating);
    approaching = (fun a b w -> Scc_naive.Fast.approaching (fast a b) Vec.zero w);
    first_time_of_contact =
      (fun a b w ->
         match Scc_naive.Fast.first_time_of_contact (fast a b) Vec.zero w with
         | Never -> Never
         | Inside -> Inside
         | At t -> At t);
  }

(* {1 Properties} *)

let straight name ?steered ?(of_network = Fun.id) ?(of_model = Fun.id) ~count ~limit other =
  QCheck2.Test.make ~name ~count ~print:Random_network.print (Random_network.generate ?steered ()) (fun n ->
      let m, start = Random_network.start (of_network n) in
      agrees ~limit other (of_model m, start))

let turning name ?(of_model = Fun.id) features ~count ~limit other =
  QCheck2.Test.make ~name ~count ~print:Random_rigid.print (Random_rigid.generate features) (fun n ->
      let m, start = Random_rigid.start n in
      agrees ~limit other (of_model m, start))

let bare m = Semantics.make m
let together m = { m with Model.collisions = Together }
let by_contact m = { m with Model.binding = On_contact }
let naive m = Semantics.make ~geometry:by_all_axes m

let suite =
  let tests = Scc_test_support.Property.cases in
  ("kernel",
   [
     ( "all pairs, nothing remembered",
       tests
         [
           straight "in translation" ~count:160 ~limit:25 bare;
           straight "with laws of motion" ~steered:true ~count:120 ~limit:25 bare;
           straight "among many" ~of_network:Random_network.with_bystanders ~count:16 ~limit:8 bare;
           turning "bodies that turn" Random_rigid.anything ~count:16 ~limit:8 bare;
           turning "with laws and rounding" { Random_rigid.anything with laws = true; rounds = true } ~count:12
             ~limit:8 bare;
           straight "collisions together" ~of_model:together ~count:40 ~limit:25 bare;
           straight "binding by contact" ~of_model:by_contact ~count:40 ~limit:25 bare;
           straight "both, with laws of motion" ~of_model:(fun m -> by_contact (together m)) ~steered:true
             ~count:40 ~limit:25 bare;
           QCheck2.Test.make ~name:"bonds that close rings" ~count:25 ~print:Random_network.print
             Random_network.linked
             (fun n -> agrees ~limit:25 bare (Random_network.start n));
           turning "bodies that turn, collisions together" ~of_model:together Random_rigid.anything ~count:8
             ~limit:8 bare;
         ] );
     ( "motion is a path",
       tests
         [
           QCheck2.Test.make ~name:"straight" ~count:40 ~print:Random_network.print
             (Random_network.generate ~steered:true ())
             (fun n -> along_its_paths ~steps:25 (Random_network.start n));
           QCheck2.Test.make ~name:"turning" ~count:16 ~print:Random_rigid.print
             (Random_rigid.generate Random_rigid.anything)
             (fun n -> along_its_paths ~steps:5 (Random_rigid.start n));
         ] );
     ("by all separating axes", tests [ straight "in translation" ~count:120 ~limit:12 naive ]);
   ])
