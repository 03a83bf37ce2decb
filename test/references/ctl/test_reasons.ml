(* What explanations and doubts say, on small graphs. *)

open Scc_ctl
open Scc_exact
open Scc_test_ctl
open Timed_formula
open Letters

(* {1 Explanations} *)

let why g f = Explanation.explain (Small.evaluator g) f (Positions.start 0)

let move (s : Run.step) =
  match s.move with Edge k -> Printf.sprintf "%d.%d" s.source k | Flow k -> Printf.sprintf "%d~%d" s.source k

let shown (r : Run.t) =
  let finish =
    match r.finish with
    | At_state -> "at"
    | During { moment; sample } ->
      Printf.sprintf "during %s%s at %s" (Algebraic.to_string moment.offset)
        (if moment.attained then "" else "+") (Algebraic.to_string sample)
    | Rests -> "rests"
    | Stops -> "stops"
    | Repeats k -> Printf.sprintf "repeats %d" k
    | Passes left -> "passes " ^ Algebraic.to_string left
  in
  String.concat " " (List.map move r.steps @ [ finish; string_of_int r.last ])

let chain g f = match Explanation.chain (why g f) with Some r -> shown r | None -> "-"

let explanations () =
  let check text expected g f = Alcotest.(check string) text expected (chain g f) in
  check "EF: the fewest steps" "0.0 during 2 at 2 1" runs (ef p);
  check "AF: a loop that takes time" "0.1 2~0 repeats 1 2" runs (af p);
  check "AG" "0.0 during 2 at 2 1" runs (ag (Not p));
  check "within: the earliest" "0~0 1~0 at 2" line (ef ~b:(bound 0 ~high:3) p);
  check "within: passed" "0~0 passes 0 1" line (af ~b:(bound 0 ~high:2) p);
  check "nested: one run after the other" "0~0 1~0 at 2" line (ef (And [ ef p; ex (Or []) |> fun f -> Not f ]));
  check "[a, b]" "0~0 1~0 at 2" line (ef ~b:(bound 3 ~high:3) p);
  check "[a, b], missed" "0~0 passes 1/2 1" line
    (Finally (All, { low = Rat.make (Z.of_int 5) (Z.of_int 2); high = Some (Rat.make (Z.of_int 5) (Z.of_int 2))
                   }, p) |> fun f -> Not f |> fun f -> Not f);
  check "an open interval" "during 1+ at 3/2 0" (from_start "..T.." "....." "..") (ef p);
  check "a dead end" "0~0 stops 1" (from_start "....." "....." "..") (af p);
  check "round within one instant, for want of a run on which time goes on" "0.0 1.0 repeats 0 0"
    (zeno_then (node "T.")) (af p);
  check "time goes on" "0.0 1~0 stops 2" (zeno_then (node "..")) (af p);
  check "round within one instant, before the interval" "0.0 1.0 repeats 0 0" (zeno_then (node "T."))
    (af ~b:(bound 1) p);
  (match (why line (ef q)).because with
   | Everywhere (lazy n) -> Alcotest.(check int) "all that is reached" 3 n
   | _ -> Alcotest.fail "a run to what is nowhere");
  match (why truncated (eg (Not p))).because with
  | Run { run; _ } -> Alcotest.(check string) "EG: a run that rests" "0.1 rests 2" (shown run)
  | _ -> Alcotest.fail "no run"

let doubts () =
  let find g f = Doubts.find (Small.evaluator g) f (Positions.start 0) in
  let d = find truncated (ef p) in
  Alcotest.(check (list int)) "the node that matters" [ 1 ] d.unexplored;
  Alcotest.(check bool) "nothing else" true (d.undefined = []);
  let d = find (graph [ node ".." ~edges:[ 1 ]; node "?." ]) (ef p) in
  (match d.undefined with
   | [ { predicate = 0; position; reason = "unsure" } ] -> Alcotest.(check int) "where" 1 position.node
   | _ -> Alcotest.fail "not what is undefined");
  let first = node ".." ~flow:(Lasts (2, [ 1 ])) ~p:"..." ~q:"..." ~edges:[ 2 ] in
  let late = graph [ first; node ".." ~known:false; node ".." ~known:false ] in
  Alcotest.(check (list int)) "in time only" [ 2 ] (find late (ef ~b:(bound 0 ~high:1) p)).unexplored;
  Alcotest.(check (list int)) "both" [ 1; 2 ] (find late (ef ~b:(bound 0 ~high:2) p)).unexplored

(* {1 From properties} *)

let translation () =
  let open Scc_property.Property in
  let a = Compare (Scc_calculus.Law.Le, Const Rat.one, Quantity Processes) and b = Fact (Touching (0, 1)) in
  let b0 = { low = Rat.zero; high = None } in
  let until = Until (All, b0, State a, State b) in
  let formulas, props =
    Scc_property.Skeleton.of_temporal [ until; Temporal_not (Globally (Exists, b0, State b)) ]
  in
  Alcotest.(check int) "equal predicates are one" 2 (Array.length props);
  Alcotest.(check (list string))
    "formulas" [ "A(p U q)"; "!EG q" ]
    (List.map Small.print_formula formulas)

let suite =
  let quick name f = Alcotest.test_case name `Quick f in
  ("reasons",
   [
     ("reasons", [ quick "explanations" explanations; quick "doubts" doubts ]);
     ("properties", [ quick "translation" translation ]);
   ])
