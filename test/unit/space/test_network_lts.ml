(* The compact transition system against the rules: the same states and transitions, in the same order. *)

open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_graph_search
open Scc_state_space
open Scc_test_networks

let standard = Scc_engine.Standard.of_model
module Graph = State_graph

(* What differs in the transitions of a state, if anything. *)
let difference context m tuple =
  let catalogue = Network_lts.catalogue context in
  let state = Catalogue.decode catalogue tuple in
  if Catalogue.encode catalogue state <> tuple then Some "a state is not its numbers"
  else
    match (Network.successors (standard m) state, Network_lts.successors context tuple) with
    | Error _, Error _ | Error (Persistent_contact _), Ok [] -> None
    | Ok expected, Ok steps ->
      let same (t : Transition.t) (s : Lts.step) =
        Transition.equal_label t.label (Catalogue.label_of catalogue s.label)
        && State.equal t.target (Catalogue.decode catalogue (Tuples.apply s.changes tuple))
      in
      if List.compare_lengths expected steps = 0 && List.for_all2 same expected steps then None
      else Some "transitions differ"
    | Ok _, Error _ | Error _, Ok _ -> Some "a fault on one side"

let explored ?(memory = 1 lsl 14) ?few m start ~states =
  let context = Network_lts.make ~memory ?few (standard m) start in
  let limits = { Limits.unlimited with states = Some states } in
  let g = Graph.run limits Limits.quiet context in
  let differences = List.filter_map (fun i -> difference context m (Graph.tuple g i)) in
  (Graph.size g, differences (List.init (Graph.size g) Fun.id))

let agrees ?few ~memory ~of_model network =
  let m, start = Random_network.start network in
  let m = of_model m in
  match explored ~memory ?few m start ~states:40 with
  | _, [] -> true
  | _, why :: _ -> QCheck2.Test.fail_report why

let property name ?steered ?few ?(of_model = Fun.id) ~memory count =
  QCheck2.Test.make ~name ~count ~print:Random_network.print
    (Random_network.generate ?steered ())
    (agrees ?few ~memory ~of_model)

(* Two processes in turns of different lengths are not one, nor is one whose turn is due. *)
let turns () =
  let e = Scc_test_models.Load.(exactly (file "../../../specs/models/tumble.sc")) in
  let catalogue = Network_lts.catalogue (Network_lts.make (standard e.model) e.declared) in
  let state lasts =
    let turning (p : State.process) = State.with_turn ~spin:p.spin ~since:Scc_exact.Rat.zero ~lasts p in
    let processes = List.map turning (Array.to_list e.declared.processes) in
    State.make ~processes ~step:None ~time:e.declared.time
  in
  List.iter
    (fun lasts ->
       let s = state lasts in
       Alcotest.(check bool) "back from its numbers" true
         (State.equal s (Catalogue.decode catalogue (Catalogue.encode catalogue s))))
    [ None; Some Scc_exact.Rat.one; Some (Scc_exact.Rat.of_int 2) ]

let rigid =
  let features = { Random_rigid.anything with rounds = true; laws = true } in
  QCheck2.Test.make ~name:"rigid" ~count:10 ~print:Random_rigid.print (Random_rigid.generate features)
    (fun network ->
       let m, start = Random_rigid.start network in
       match explored ~memory:1024 m start ~states:15 with
       | _, [] -> true
       | _, why :: _ -> QCheck2.Test.fail_report why)

let crowd name ~few =
  QCheck2.Test.make ~name ~count:12 ~print:Random_network.print Random_network.crowd
    (agrees ~few ~memory:1024 ~of_model:Fun.id)

(* Looked at as many are: with some absorbed, and with so many at rest that sweeps are asked. *)
let absorbing =
  QCheck2.Test.make ~name:"some are absorbed" ~count:40 ~print:Random_network.print (Random_network.absorbing ())
    (agrees ~few:0 ~memory:1024 ~of_model:Fun.id)

let bystanders =
  QCheck2.Test.make ~name:"bystanders" ~count:20 ~print:Random_network.print (Random_network.generate ())
    (fun network -> agrees ~few:0 ~memory:1024 ~of_model:Fun.id (Random_network.with_bystanders network))

let switched name ~steered count =
  QCheck2.Test.make ~name ~count ~print:Random_network.print
    (Random_network.switched ~steered ())
    (agrees ~memory:1024 ~of_model:Fun.id)

let rings =
  QCheck2.Test.make ~name:"bonds that close rings" ~count:40 ~print:Random_network.print Random_network.linked
    (agrees ~memory:1024 ~of_model:Fun.id)

let model ?few name () =
  let e = Scc_test_models.Load.(exactly (file ("../../../specs/models/" ^ name))) in
  match Network.initial (standard e.model) e.declared with
  | Error _ -> Alcotest.fail "no initial state"
  | Ok start ->
    let size, differences = explored ?few e.model start ~states:300 in
    Alcotest.(check (list string)) "no difference" [] differences;
    Alcotest.(check bool) "some states" true (size > 0)

(* Which events led to a state is part of it, and gone when time passes. *)
let events () =
  let e = Scc_test_models.Load.(exactly (file "../../../specs/models/chain.sc")) in
  let bind : Property.event = Bond (Made, Some "link", Any) and bounce : Property.event = Bounce Any in
  let start = Result.get_ok (Network.initial (standard e.model) e.declared) in
  let context = Network_lts.make ~events:[ bind; bounce ] (standard e.model) start in
  let g = Graph.run Limits.unlimited Limits.quiet context in
  let label (edge : Graph.edge) = Catalogue.label_of (Network_lts.catalogue context) edge.label in
  let seen = ref 0 in
  for i = 0 to Graph.size g - 1 do
    Array.iter
      (fun (edge : Graph.edge) ->
         let is_bind = match label edge with Bind _ -> true | _ -> false in
         if is_bind then incr seen;
         let target = Graph.tuple g edge.target in
         Alcotest.(check bool) "bind" is_bind (Network_lts.arrived context bind target);
         Alcotest.(check bool) "bounce" false (Network_lts.arrived context bounce target))
      (Graph.edges g i)
  done;
  Alcotest.(check int) "binds" 3 !seen;
  Alcotest.(check bool) "not at the start" false (Network_lts.arrived context bind (Graph.tuple g 0))

let () =
  let models = List.sort String.compare (Array.to_list (Sys.readdir "../../../specs/models")) in
  let models = List.filter (fun f -> Filename.check_suffix f ".sc") models in
  Alcotest.run "system"
    [
      ( "random networks",
        Scc_test_support.Property.cases
          [
            property "inertial" ~memory:1024 200;
            property "steered" ~steered:true ~memory:1024 60;
            property "little memory" ~memory:2 100;
            property "collisions together" ~of_model:(fun m -> { m with collisions = Together }) ~memory:1024 100;
            property "binding by contact" ~of_model:(fun m -> { m with binding = On_contact }) ~memory:1024 100;
            property "as many" ~few:0 ~memory:1024 200;
            property "as many, with little memory" ~few:0 ~memory:2 100;
            crowd "crowds" ~few:0; crowd "crowds by pairs" ~few:1000; absorbing; bystanders; rings; rigid;
            switched "with switches" ~steered:false 60; switched "with switches, under laws" ~steered:true 60;
          ] );
      ("models", List.map (fun name -> Alcotest.test_case name `Quick (model name)) models);
      ("models as many", List.map (fun name -> Alcotest.test_case name `Quick (model ~few:0 name)) models);
      ("events", [ Alcotest.test_case "what led to a state" `Quick events ]);
      ("turns", [ Alcotest.test_case "how long they last" `Quick turns ]);
    ]
