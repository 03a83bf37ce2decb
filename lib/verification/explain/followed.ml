open Scc_base
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_state_space
module Graph = State_graph

type t = { last : State.t; steps : Witness.step list }

let start context = { last = Network_lts.start context; steps = [] }
let from last = { last; steps = [] }

(* Of the choices the one that was made on the graph is looked at first: as a rule nobody needs the others. *)
let step context from wanted target =
  match Network_lts.choices context from.last with
  | Error _ -> Bug.fail __POS__ "a witness does not replay: a fault on its way"
  | Ok choices ->
    let standing = lazy (Network_lts.representative context target) in
    let leads_there (_, t) =
      let t = Lazy.force t in
      t = target || t = Lazy.force standing
    in
    let rec first k = function
      | [] -> Bug.fail __POS__ "a witness does not replay"
      | choice :: rest -> if leads_there choice then (k, choice) else first (k + 1) rest
    in
    let choice, (transition, _) =
      match List.nth_opt choices wanted with
      | Some made when leads_there made -> (wanted, made)
      | Some _ | None -> first 0 choices
    in
    let before = match from.steps with [] -> Rat.zero | s :: _ -> s.time in
    let time = Rat.add before (Transition.duration transition) in
    { last = transition.target; steps = { Witness.choice; transition; time } :: from.steps }

let along context graph =
  List.fold_left (fun from (step_ : Graph.step) ->
      let target = Graph.tuple graph (Graph.edges graph step_.source).(step_.choice).target in
      step context from step_.choice target)
