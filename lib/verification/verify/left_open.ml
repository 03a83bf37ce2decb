open Scc_calculus
open Scc_semantics

let at_any_time (m : Model.t) ~declared =
  match m.splits with Any_time -> Parameters.may_split m declared | Every _ -> false

let leaves_open (m : Model.t) ~declared = Array.length m.ranges > 0 || at_any_time m ~declared

let make semantics ~declared ~example ~everywhere ~by_invariant =
  let m = Semantics.model semantics in
  let instants = at_any_time m ~declared in
  let over = { Verdict.instants; ranges = m.ranges; example; everywhere; by_invariant } in
  let split_step =
    match m.splits with Every step when Parameters.may_split m declared -> Some step | Every _ | Any_time -> None
  in
  { Verdict.resolution = None; split_step; over = Some over }
