(* Random graphs against the definitions. *)

open Scc_data
open Scc_equivalence
open Scc_naive_equivalence

let labels = [ "tau"; "tau"; "a"; "b" ]

let graph_gen ?(most = 6) () =
  let open QCheck2.Gen in
  let* size = int_range 1 most in
  let* edges = int_range 0 (2 * size) in
  let+ list =
    list_repeat edges (triple (int_range 0 (size - 1)) (oneofl labels) (int_range 0 (size - 1)))
  in
  (size, list)

(* A graph and one that is like it: an edge more or less, or a silent detour. *)
let pair_gen =
  let open QCheck2.Gen in
  let* (size, edges) = graph_gen () in
  let* other = graph_gen () in
  let* how = int_range 0 4 in
  let* s = int_range 0 (size - 1) and* t = int_range 0 (size - 1) and* l = oneofl labels in
  let detour = function (a, m, b) :: rest -> (a, "tau", size) :: (size, m, b) :: rest | [] -> [] in
  return
    ( (size, edges),
      match how with
      | 0 -> other
      | 1 -> (size, (s, l, t) :: edges)
      | 2 -> (size, (match edges with _ :: rest -> rest | [] -> []))
      | 3 -> (size + 1, detour edges)
      | _ ->
        let copied = List.filter_map (fun (a, m, b) -> if a = s then Some (size, m, b) else None) edges in
        (size + 1, (s, "tau", size) :: (copied @ edges)) )

let print (size, edges) =
  Printf.sprintf "%d states: %s" size
    (String.concat " " (List.map (fun (s, l, t) -> Printf.sprintf "%d-%s->%d" s l t) edges))

let print_pair (a, b) = print a ^ "\n" ^ print b
let make (size, edges) = Naive.make size edges

let run relation g h =
  Compare.run (Effort.unlimited ()) relation (Compare.prepare relation g) (Compare.prepare relation h)

let equivalent relation g h =
  match (run relation g h).verdict with
  | Compare.Equivalent -> true
  | Different _ -> false
  | Undecided _ -> QCheck2.Test.fail_report "undecided"

let agrees name relation naive count =
  QCheck2.Test.make ~name ~count ~print:print_pair pair_gen (fun (a, b) ->
      let g = make a and h = make b in
      Naive.related naive g h = equivalent relation g h)

let partitions ?most name kind naive =
  let count = if Option.is_none most then 3000 else 1000 in
  QCheck2.Test.make ~name ~count ~print (graph_gen ?most ()) (fun a ->
      let g = make a in
      let p = Quotient.blocks (Effort.unlimited ()) kind g in
      let r = Naive.bisimilar naive g in
      let same = ref true in
      for s = 0 to g.size - 1 do
        for t = 0 to g.size - 1 do
          if (Int_array.get p.block s = Int_array.get p.block t) <> r.(s).(t) then same := false
        done
      done;
      !same && Naive.related naive g (Graph.reachable (Quotient.make kind g p)))

let traces =
  QCheck2.Test.make ~name:"traces agree with enumeration" ~count:1500 ~print:print_pair pair_gen (fun (a, b) ->
      let g = make a and h = make b in
      match (run Trace g h).verdict with
      | Equivalent -> Naive.traces 5 g = Naive.traces 5 h
      | Different { trace = Some (steps, first); _ } ->
        let n = List.length steps in
        let has, lacks = if first then (g, h) else (h, g) in
        List.mem steps (Naive.traces n has)
        && (not (List.mem steps (Naive.traces n lacks)))
        (* and it is a shortest one *)
        && Naive.traces (n - 1) g = Naive.traces (n - 1) h
      | Different { trace = None; _ } | Undecided _ -> false)

let hierarchy =
  QCheck2.Test.make ~name:"strong => branching => weak => trace" ~count:1000 ~print:print_pair pair_gen
    (fun (a, b) ->
       let g = make a and h = make b in
       let implies x y = (not x) || y in
       let e r = equivalent r g h in
       implies (e Strong) (e Branching) && implies (e Branching) (e Weak) && implies (e Weak) (e Trace))

(* The text of the formula, read again and evaluated by the definitions of the modalities. *)
let explained relation name =
  QCheck2.Test.make ~name ~count:1500 ~print:print_pair pair_gen (fun (a, b) ->
      let g = make a and h = make b in
      let report = run relation g h in
      match report.verdict with
      | Different { trace_open = true; _ } | Different { formula = None; _ } -> false
      | Different { formula = Some f; _ } ->
        let text = report.show f in
        let f = Naive_logic.parse text in
        (Naive_logic.holds g f 0 && not (Naive_logic.holds h f 0)) || QCheck2.Test.fail_report text
      | Equivalent -> true
      | Undecided _ -> false)

(* {1 Unknown states} *)

let truncated_gen =
  let open QCheck2.Gen in
  let* a, b = pair_gen in
  let* cut_a = list_size (int_range 0 2) (int_range 0 (fst a - 1)) in
  let+ cut_b = list_size (int_range 0 2) (int_range 0 (fst b - 1)) in
  ((a, cut_a), (b, cut_b))

let cut ((size, edges), unknown) =
  Naive.make ~unknown size (List.filter (fun (s, _, _) -> not (List.mem s unknown)) edges)

(* What is said of the known part holds of the whole. *)
let truncated relation naive name =
  let print ((a, c), (b, d)) =
    let list l = String.concat "," (List.map string_of_int l) in
    Printf.sprintf "%s cut at %s\n%s cut at %s" (print a) (list c) (print b) (list d)
  in
  QCheck2.Test.make ~name ~count:1500 ~print truncated_gen (fun (a, b) ->
      let g = make (fst a) and h = make (fst b) in
      match (run relation (cut a) (cut b)).verdict with
      | Equivalent -> Graph.complete (Compare.prepare relation (cut a)) && naive g h
      | Different _ -> not (naive g h)
      | Undecided _ -> true)

let same_traces g h = Naive.traces 6 g = Naive.traces 6 h

let suite =
  ("random graphs",
   [
     ( "partitions",
       Scc_test_support.Property.cases
         [
           partitions "strong" Refine.Strong Strong;
           partitions "branching" Refine.Branching Branching;
           partitions "weak" Refine.Weak Weak;
           partitions ~most:14 "strong, larger" Refine.Strong Strong;
           partitions ~most:14 "branching, larger" Refine.Branching Branching;
           partitions ~most:14 "weak, larger" Refine.Weak Weak;
         ] );
     ( "comparison",
       Scc_test_support.Property.cases
         [
           agrees "strong agrees with the definition" Strong Strong 3000;
           agrees "branching agrees with the definition" Branching Branching 3000;
           agrees "weak agrees with the definition" Weak Weak 3000;
           traces;
           hierarchy;
         ] );
     ( "explanations",
       Scc_test_support.Property.cases
         [
           explained Strong "every difference has a formula: strong";
           explained Branching "every difference has a formula: branching";
           explained Weak "every difference has a formula: weak";
         ] );
     ( "unknown states",
       Scc_test_support.Property.cases
         [
           truncated Strong (Naive.related Strong) "strong";
           truncated Branching (Naive.related Branching) "branching";
           truncated Weak (Naive.related Weak) "weak";
           truncated Trace same_traces "trace";
         ] );
   ])
