(* Long graphs: nothing goes deeper into the stack with the number of nodes. *)

open Scc_ctl
open Scc_exact
open Timed_formula

let size = 200_000
let always = { Timed_formula.low = Rat.zero; high = None }
let until n = { always with high = Some (Rat.of_int n) }

(* A line on which every second way takes 1, to the last node, of which [ends] says what follows. *)
let line ends : Timed_graph.t =
  let last = size - 1 in
  let on s = s < last && s land 1 = 0 in
  {
    size;
    known = (fun s -> s < last || match ends with `Unknown -> false | `Dead_end | `Back -> true);
    edges =
      (fun s ->
         if s < last && not (on s) then [| s + 1 |]
         else match ends with `Back when s = last -> [| 0 |] | _ -> [||]);
    drawn = (fun _ -> None);
    flow = (fun s -> if on s then Lasts (Rat.one, [| s + 1 |]) else No_flow);
  }

let ring : Timed_graph.t =
  {
    size;
    known = (fun _ -> true);
    edges = (fun s -> [| (s + 1) mod size |]);
    drawn = (fun _ -> None);
    flow = (fun _ -> No_flow);
  }

(* p: the last node. *)
let evaluator graph =
  let at _ s = Truth.of_bool (s = size - 1) in
  Eval.create (Timed_graph.index graph)
    { at; along = (fun _ _ extent -> Timeline.constant extent Truth.False); steady = (fun _ -> false) }

let p = Predicate 0
let never = And [ p; Not p ]
let start = Positions.start 0

let run graph f =
  match Explanation.explain (evaluator graph) f start with
  | { because = Run { run; _ }; holds; _ } -> (holds, List.length run.steps, run.finish)
  | _ -> Alcotest.fail "no run"

let steps text expected graph f =
  let holds, n, _ = run graph f in
  Alcotest.(check (pair bool int)) text expected (holds, n)

let half = size / 2

let lines () =
  let g = line `Dead_end in
  steps "EF" (true, size - 1) g (Finally (Exists, always, p));
  steps "AF" (false, size - 1) g (Finally (All, always, never));
  steps "EF in time" (true, size - 1) g (Finally (Exists, until half, p));
  steps "AF not in time" (false, size - 4) g (Finally (All, until (half - 2), p));
  steps "AX" (false, 2) g (Next (All, p));
  steps "EF from 2 on" (true, size - 1) g
    (Finally (Exists, { always with low = Rat.of_int 2 }, p));
  let holds f = Eval.truth (evaluator g) f start in
  Alcotest.(check (option bool)) "AF in time" (Some true) (holds (Finally (All, until half, p)));
  Alcotest.(check (option bool)) "just not" (Some false) (holds (Finally (All, until (half - 1), p)))

let cycles () =
  steps "a lasso" (false, size) (line `Back) (Finally (All, always, never));
  steps "round within one instant" (false, size) ring (Finally (All, always, never))

let ends () =
  let e = evaluator (line `Unknown) in
  let f = Finally (Exists, always, never) in
  Alcotest.(check (list int)) "the last node" [ size - 1 ] (Doubts.find e f start).unexplored;
  Alcotest.(check (option bool)) "passed before" (Some false)
    (Eval.truth e (Finally (All, until (half - 1), never)) start)

let suite =
  let quick name f = Alcotest.test_case name `Quick f in
  ("long",
   [ ("graphs", [ quick "lines" lines; quick "cycles" cycles; quick "an unknown end" ends ]) ])
