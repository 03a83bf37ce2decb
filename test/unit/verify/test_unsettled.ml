(* Why states were not expanded, against a look at each of them. *)

open Scc_exact
open Scc_graph_search
open Scc_state_space
open Scc_verify
open Scc_test_models
module Graph = State_graph

let standard = Scc_engine.Standard.of_model

(* Several bounds are met in most of these. *)
let limits =
  let all l f = List.concat_map f l in
  all [ 2; 3; 4; 5; 6; 8 ] (fun depth ->
      all [ 1; 2; 3; 4; 6 ] (fun halves ->
          List.map
            (fun states ->
               let time = Rat.make (Z.of_int halves) (Z.of_int 2) in
               { Limits.unlimited with depth = Some depth; time = Some time; states = Some states })
            [ 30; 200 ]))

let unsettled path limits : Unsettled.t =
  let e = Load.exactly (Load.file path) in
  let semantics = standard e.model in
  let initial =
    match Scc_semantics.Network.initial semantics e.declared with
    | Ok initial -> initial
    | Error _ -> Alcotest.fail "no initial state"
  in
  let context = Network_lts.make semantics initial in
  let graph = Graph.run limits Limits.quiet context in
  {
    bounds = Bounds.default; surroundings = Limits.quiet; model = e.model; context; graph; horizon = None;
    lost = Lost.make Bounds.default Limits.quiet.attempt; contrast = false;
  }

(* Faults are told of as often as they come up, other reasons once. *)
let naive (r : Unsettled.t) states =
  let reason i =
    match Graph.status r.graph i with
    | Explore.Unexpanded reason -> reason
    | Expanded | Queued -> Alcotest.fail "a state that was expanded is left"
  in
  let add found reason =
    match (reason : _ Explore.reason) with
    | Fault _ -> reason :: found
    | _ -> if List.memq reason found then found else reason :: found
  in
  List.rev (List.fold_left add [] (List.map reason states))

(* How often a second reason came after the first one had come up again. *)
let late = ref 0

let same what expected found =
  Alcotest.(check bool) what true (List.compare_lengths expected found = 0 && List.for_all2 ( == ) expected found)

let of_model path () =
  let look limits =
    let r = unsettled path limits in
    let states = List.of_seq (Seq.map fst (Graph.unexpanded r.graph)) in
    let each = List.map (fun i -> naive r [ i ]) states in
    let all = naive r states in
    (match (all, each) with
     | first :: _ :: _, _ :: [ again ] :: _ when first == again -> incr late
     | _ -> ());
    same "of all" all (Unsettled.reasons r (List.to_seq states));
    let some = List.filter (fun i -> i land 3 > 0) states in
    same "of some" (naive r some) (Unsettled.reasons r (List.to_seq some));
    List.iter
      (fun reason ->
         let has i = Graph.status r.graph i = Explore.Unexpanded reason in
         Alcotest.(check (option int)) "first" (List.find_opt has states) (Unsettled.first r reason))
      [ Explore.Depth; Time; States; Memory ]
  in
  List.iter look limits

let late_ones () = Alcotest.(check bool) "there are such" true (!late > 10)

let models =
  [
    "dissociation.sc"; "enzymes.sc"; "gas.sc"; "glycolysis.sc"; "crosslink.sc"; "filament.sc"; "capsid.sc";
    "association.sc"; "brownian.sc";
  ]

let suite =
  let case name = Alcotest.test_case name `Quick (of_model ("../../../specs/models/" ^ name)) in
  ("unsettled",
   [
     ("models", List.map case models);
     ("all", [ Alcotest.test_case "reasons that come late" `Quick late_ones ]);
   ])
