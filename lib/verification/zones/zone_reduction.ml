open Scc_property
open Scc_state_space
open Scc_verify

let displaced (options : Setup.t) model initial formulas =
  List.exists (Reduction.equal Translation) options.reductions && Quotient.translatable model initial formulas

(* An event of somebody else at the same instant ends what an event atom says, so that these may only count in
   favour of what is searched for, as in slices. *)
let visible (options : Setup.t) formulas =
  let deep = match options.bounds.depth with Given _ -> true | Default _ | Unbounded -> false in
  if List.for_all Slice.can_be_sliced formulas then
    Reduction.visible options.reductions ~deep ~searched:formulas ~evaluated:[]
  else None

let interchangeable (options : Setup.t) model initial formulas =
  let is_search f = Plan.is_search (Plan.of_formula f) in
  if List.exists (Reduction.equal Symmetry) options.reductions && List.for_all is_search formulas then
    Symmetry.classes (Symmetry.find model ~initial ~searched:formulas ~evaluated:[])
  else []
