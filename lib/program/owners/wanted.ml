open Scc_property
open Scc_state_space
open Scc_successors

type check = { place : int; check : Property.check; plan : Plan.t; first : int }

type t = {
  checks : check list;
  formulas : Formulas.asked;
  patterns : Property.prop array;
  numbers : Property.num array;
}

let means checks =
  let mean c : Property.mean option =
    match c.check.Property.asked with Expected (_, mean, _) -> Some mean | Whether | How_likely _ -> None
  in
  List.filter_map mean checks

let find filter =
  let question = Filter.question filter in
  let add (place, first, found) ((check : Property.check), (known : Question.plan)) =
    match known with
    | Other when not (Question.is_premise question check) ->
      let plan = Scc_verify.Joint_check.plan check in
      (place + 1, first + List.length (Plan.searches plan), { place; check; plan; first } :: found)
    | _ -> (place + 1, first, found)
  in
  let _, _, found = List.fold_left add (0, 0, []) question.plans in
  let checks = List.rev found in
  let formulas = List.concat_map (fun c -> Plan.searches c.plan) checks in
  let pattern : Property.mean -> Property.prop option = function
    | Events_until (p, _) -> Some p
    | Time_until _ | Value_at _ -> None
  in
  let number : Property.mean -> Property.num option = function
    | Value_at (n, _) -> Some n
    | Time_until _ | Events_until _ -> None
  in
  {
    checks;
    formulas = Formulas.ask (Filter.context filter) formulas;
    patterns = Array.of_list (List.filter_map pattern (means checks));
    numbers = Array.of_list (List.filter_map number (means checks));
  }

let steady w p = Option.is_none (Formulas.predicates w.formulas).(p).Scc_ctl.On_the_fly.along

(* They are those of the checks themselves. *)
let place all one =
  let rec from k = if all.(k) == one then k else from (k + 1) in
  from 0

let pattern w = place w.patterns
let number w = place w.numbers
