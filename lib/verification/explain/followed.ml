open Scc_base
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_state_space
module Graph = State_graph

type t = { last : State.t; steps : Witness.step list }

let numbered list = List.mapi (fun k x -> (k, x)) list
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

(* Draws that are one edge of the graph, one by one. Those are tried first that give processes the velocities that
   they have in the end. *)
let draws context from target =
  let catalogue = Network_lts.catalogue context in
  let wanted =
    let moving (p : State.process) = (p.leaves.(0).leaf, (p.velocity, p.spin)) in
    match Network_lts.draws_towards context from.last target with
    | Some velocities -> List.map (fun (p, v) -> (p, (v, Vec.zero))) velocities
    | None -> List.map moving (Array.to_list (Catalogue.decode catalogue target).processes)
  in
  let fits ((t : Transition.t), _) =
    match t.label with
    | Draw { first; given = { velocity; spin }; _ } ->
      let moves_so (v, w) = Vec.equal velocity v && Option.fold ~none:true ~some:(Vec.equal w) spin in
      List.exists (fun (p, motion) -> p = first && moves_so motion) wanted
    | _ -> false
  in
  let standing = lazy (Network_lts.representative context target) in
  let leads_there (_, t) =
    let t = Lazy.force t in
    t = target || t = Lazy.force standing
  in
  let after from (choice, ((transition : Transition.t), _)) =
    let time = match from.steps with [] -> Rat.zero | s :: _ -> s.Witness.time in
    { last = transition.target; steps = { Witness.choice; transition; time } :: from.steps }
  in
  let rec search from =
    match Network_lts.choices context from.last with
    | Error _ -> Bug.fail __POS__ "a witness does not replay: a fault on its way"
    | Ok choices ->
      let is_drawn (_, ((t : Transition.t), _)) = Transition.is_drawn t.label in
      let drawn = List.filter is_drawn (numbered choices) in
      let there = List.find_opt (fun (_, choice) -> leads_there choice) drawn in
      let first, others = List.partition (fun (_, choice) -> fits choice) drawn in
      let on choice = search (after from choice) in
      (match there with
       | Some choice -> Some (after from choice)
       | None -> List.find_map on (first @ others))
  in
  match search from with Some reached -> reached | None -> Bug.fail __POS__ "a witness does not replay"

let along context graph =
  List.fold_left (fun from (step_ : Graph.step) ->
      let edge = (Graph.edges graph step_.source).(step_.choice) in
      let target = Graph.tuple graph edge.target in
      match Catalogue.single (Network_lts.catalogue context) edge.label with
      | Some _ -> step context from step_.choice target
      | None -> draws context from target)
