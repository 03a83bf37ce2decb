(* The same of random networks: states are told by their bytes, whatever numbers a process has for their parts. *)

open Scc_exact
open Scc_graph_search
open Scc_state_space
open Scc_parallel
open Scc_test_networks
module Graph = State_graph
module Journal = Journal.Make (Network_lts) (Network_exchange) (State_graph)
module Crews = Crew.Make (Network_lts) (State_graph)

let semantics model = Scc_engine.Standard.of_model model

(* All states of a part of the graph, with their edges, in the order in which they are found. *)
let told ?expanding ~keep_edges network =
  let model, initial = Random_network.start network in
  let quotient = { Quotient.none with translation = Quotient.translatable model initial [] } in
  let context = Network_lts.make ~quotient (semantics model) initial in
  let limits = { Limits.unlimited with states = Some 120; depth = Some 8 } in
  let g = Graph.run ~keep_edges ?expanding limits Limits.quiet context in
  let codec = Network_lts.codec context and catalogue = Network_lts.catalogue context in
  let edge (e : Graph.edge) =
    let label = Catalogue.label_of catalogue e.label in
    Printf.sprintf "%s -> %d" (Scc_semantics.Transition.label_to_string model label) e.target
  in
  let state i =
    let bytes = Scc_codec.State_codec.encode codec (Catalogue.decode catalogue (Graph.tuple g i)) in
    Printf.sprintf "%s %d %s %s" (Digest.to_hex (Digest.string bytes)) (Graph.depth g i)
      (Rat.to_string (Graph.arrival g i))
      (String.concat "; " (List.map edge (Array.to_list (Graph.edges g i))))
  in
  let split_step = match Network_lts.split_step context with None -> "" | Some s -> Rat.to_string s in
  Printf.sprintf "%s, %d transitions\n%s" split_step (Graph.transitions g)
    (String.concat "\n" (List.init (Graph.size g) state))

let same network text expected =
  String.equal text expected
  || QCheck2.Test.fail_reportf "%s\n\n%s\n\ninstead of\n\n%s" (Random_network.print network) text expected

let by_crew = Crews.expanding ~jobs:2 ~start:At_once

let shared network =
  let expected = told ~keep_edges:true network in
  same network (told ~expanding:by_crew ~keep_edges:true network) expected
  && same network (told ~expanding:by_crew ~keep_edges:false network) (told ~keep_edges:false network)

let kept network =
  let expected = told ~keep_edges:false network in
  let log, blocks = Kept_in_memory.log [] in
  let run log = told ~expanding:(Journal.expanding ~block:1 log Graph.here) ~keep_edges:false network in
  let first = run log in
  let half = List.filteri (fun i _ -> 2 * i < List.length (blocks ())) (blocks ()) in
  same network first expected && same network (run (fst (Kept_in_memory.log half))) expected

(* With all tables in mapped files, which processes that are forked have as well. *)
let in_files network =
  let expected = told ~keep_edges:true network in
  let folder = Filename.get_temp_dir_name () in
  Scc_data.Spill.to_folder folder ~beyond:0;
  Fun.protect ~finally:Scc_data.Spill.nowhere (fun () ->
      same network (told ~keep_edges:true network) expected
      && same network (told ~expanding:by_crew ~keep_edges:true network) expected)

let test ~count name f =
  let networks = Random_network.switched ~steered:true () in
  QCheck2.Test.make ~count ~name ~print:Random_network.print networks f

let () =
  Alcotest.run "expand networks"
    [
      ( "random networks",
        Scc_test_support.Property.cases
          [
            test ~count:25 "two processes find what one finds" shared;
            test ~count:40 "what was kept is followed" kept;
            test ~count:16 "with tables in files" in_files;
          ] );
    ]
