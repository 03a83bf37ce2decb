open Scc_exact
open Scc_calculus
open Scc_semantics

(* An event that is possible at a state which a hypothesis reaches, now or by the passing of time. *)
type t = { at : State.t; time : Rat.t; taken : Transition.t; from : Trace_search.hypothesis }

(* How far is looked ahead: hypotheses, instants of each. *)
let looked_from = 12
let looked_instants = 200

let events transitions = List.filter (fun (x : Transition.t) -> not (Transition.is_time x.label)) transitions

(* The events of the instants on the way, up to the first after [past] at which there are any. *)
let until against ~observed ~past (h : Trace_search.hypothesis) =
  let at_place (at, time) =
    match Network.successors (Against.semantics against) at with
    | Error _ -> []
    | Ok transitions ->
      let seen (x : Transition.t) = observed x.label in
      List.filter seen (events transitions) |> List.map (fun taken -> { at; time; taken; from = h })
  in
  let over time = match past with None -> true | Some past -> Rat.compare time past > 0 in
  let rec collect found = function
    | [] -> found
    | ((_, time) as place) :: rest ->
      let here = at_place place in
      if here <> [] && over time then found @ here else collect (found @ here) rest
  in
  collect [] (Trace_search.beyond against h.state h.time ~steps:looked_instants)

let at_first_instant against ~observed h = until against ~observed ~past:None h

let same_option a b = Rat.equal a.time b.time && Transition.equal_label a.taken.label b.taken.label

let distinct options =
  List.fold_left
    (fun kept o -> if List.exists (same_option o) kept then kept else o :: kept)
    [] options
  |> List.rev

let most_options = 500

let find against ~observed ~past (dead : Trace_search.dead_end) =
  let seen (p : Trace_search.possible) = observed p.taken.label in
  let here =
    List.filter seen dead.possible
    |> List.filteri (fun i _ -> i < most_options)
    |> List.map (fun (p : Trace_search.possible) ->
        { at = p.from.state; time = p.from.time; taken = p.taken; from = p.from })
  in
  (* Those reached first come last. The latest of them have time before them that would be too long. *)
  let latest = List.filteri (fun i _ -> i < looked_from) dead.reached in
  let ahead = List.concat_map (until against ~observed ~past:(Some past)) latest in
  distinct (here @ ahead) |> List.stable_sort (fun a b -> Rat.compare a.time b.time)

let is_urgent o = Trace_search.urgent o.taken
