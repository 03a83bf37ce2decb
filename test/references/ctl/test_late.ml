(* The time is over once the truth is known: it is explained as before, or not at all. *)

open Scc_ctl
open Scc_test_ctl
open Test_explanations

let explained c =
  let over = ref false in
  let effort = { Scc_chance.Effort.default with interrupted = (fun () -> !over); half = (fun () () -> !over) } in
  let e = Small.evaluator ~effort c.graph and p = Positions.start 0 in
  let truth = Eval.truth e c.formula p in
  over := true;
  match Explanation.explain e c.formula p with
  | x -> Option.equal Bool.equal truth (Some x.holds)
  | exception Explanation.Not_known -> true

let suite =
  let gen = case_gen ~unsure:false ~truncated:false ~depth:2 in
  let test = QCheck2.Test.make ~count:600 ~name:"explanations when the time is over" ~print gen explained in
  ("late", [ ("late", Scc_test_support.Property.cases [ test ]) ])
