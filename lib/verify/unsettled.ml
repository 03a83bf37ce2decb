open Scc_exact
open Scc_calculus
open Scc_explore
open Scc_space
open Scc_explain
module Graph = State_graph

type t = {
  bounds : Bounds.t;
  surroundings : Limits.surroundings;
  model : Model.t;
  context : Network_lts.context;
  graph : Graph.t;
  horizon : Rat.t option;
}

let cause r reason = Bounds.cause r.bounds r.model ~horizon:r.horizon reason

let reason_of r i =
  match Graph.status r.graph i with
  | Explore.Unexpanded reason -> cause r reason
  | Expanded | Queued -> Scc_base.Bug.fail __POS__ "a state that was expanded is in doubt"

(* The nearest of some states, in steps. *)
let nearest r = function
  | [] -> None
  | i :: rest ->
    let nearer best j = if Graph.depth r.graph j < Graph.depth r.graph best then j else best in
    Some (List.fold_left nearer i rest)

(* Why no answer was found in some states. *)
let causes r states : Verdict.reason list =
  let bound = function
    | Bounds.Bound t -> Some t
    | Fault _ -> None
    | Early -> Scc_base.Bug.fail __POS__ "an open question did not keep the exploration going"
  in
  let fault = function Bounds.Fault f -> Some f.Scc_base.Diag.message | Bound _ | Early -> None in
  (* There may be millions of them. *)
  let causes = List.rev (List.rev_map (reason_of r) states) in
  let bounds = Verdict.distinct (List.filter_map bound causes) in
  let faults = List.sort_uniq String.compare (List.filter_map fault causes) in
  List.map (fun t -> Verdict.Truncated t) bounds @ List.map (fun text -> Verdict.Fault text) faults

(* With a run to the nearest of them. It may be long, and take as long to be made as to be found: then it is left
   out. *)
let unexplored r states =
  let run i () = Make_witness.of_path r.context r.graph i in
  let matter i =
    match r.surroundings.attempt.run Concluding (run i) with
    | Ok nearest -> Some (Verdict.Unexplored { count = List.length states; nearest })
    | Error _ -> None
  in
  causes r states @ Option.to_list (Option.bind (nearest r states) matter)

let undefined (d : Search.doubts) = List.map (fun text -> Verdict.Undefined text) (Option.to_list d.undefined)
let search_doubts r (d : Search.doubts) = undefined d @ unexplored r d.unexplored

let doubts r (d : Scc_ctl.Doubts.t) =
  let undefined =
    List.map (fun (u : Scc_ctl.Doubts.undefined) -> u.reason) d.undefined |> List.sort_uniq String.compare
  in
  List.map (fun text -> Verdict.Undefined text) undefined
  @ unexplored r d.unexplored
