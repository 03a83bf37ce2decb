open Scc_exact
open Scc_calculus
open Scc_graph_search
open Scc_state_space
open Scc_explain
module Graph = State_graph

let formulas = Temporal.formulas

type t = {
  bounds : Bounds.t;
  surroundings : Limits.surroundings;
  model : Model.t;
  context : Network_lts.context;
  graph : Graph.t;
  horizon : Rat.t option;
  lost : Lost.t;
  contrast : bool;
}

let run r make = Lost.run r.lost (Network_lts.semantics r.context) make

(* An explanation repeats what was decided. If that comes to nothing, the time for it was over. *)
let explained r temporal i =
  let contrasted e w =
    if not r.contrast then w
    else
      try Make_witness.with_contrast r.context r.graph temporal e w
      with Scc_ctl.Explanation.Not_known | Limits.Over _ -> w
  in
  let made () =
    let e = Temporal.explain temporal i in
    Option.map (contrasted e) (Make_witness.of_explanation r.context r.graph temporal e)
  in
  let over stop = raise (Limits.Over stop) in
  let make () =
    match made () with
    | Some w -> Some w
    | None ->
      if Formulas.is_cut_short (formulas temporal) then Option.iter over (r.surroundings.stop ());
      None
    | exception Scc_ctl.Explanation.Not_known ->
      over (Option.value (r.surroundings.stop ()) ~default:Limits.Seconds)
  in
  run r make

let cause r reason = Bounds.cause r.bounds r.model ~horizon:r.horizon reason

let bounds : _ Explore.reason list = [ Depth; Time; Instant; States; Bits; Seconds; Memory; Interrupted ]

(* There may be millions of states, and few reasons: once all that there are have come up, no more is looked at. *)
let reasons r states =
  let count = Graph.left_for r.graph in
  let no_faults = Explore.Stopped :: bounds in
  let kinds = List.length (List.filter (fun b -> count b > 0) no_faults) in
  let faults = Graph.left r.graph - List.fold_left (fun n b -> n + count b) 0 no_faults in
  let rec look found kinds faults states =
    if kinds = 0 && faults = 0 then List.rev found
    else
      match states () with
      | Seq.Nil -> List.rev found
      | Cons (i, rest) -> (
          match Graph.status r.graph i with
          | Unexpanded (Fault _ as fault) -> look (fault :: found) kinds (faults - 1) rest
          | Unexpanded reason when List.memq reason found -> look found kinds faults rest
          | Unexpanded reason -> look (reason :: found) (kinds - 1) faults rest
          | Expanded | Queued -> Scc_base.Bug.fail __POS__ "a state that was expanded is in doubt")
  in
  look [] kinds faults states

let met r = List.map (cause r) (reasons r (Seq.map fst (Graph.unexpanded r.graph)))
let bound = function Bounds.Bound t -> Some t | Fault _ | Early -> None
let stopped_by causes = Verdict.distinct (List.filter_map bound causes)

let evaluated r f =
  let why stop =
    List.map (fun t -> Verdict.Truncated t) (stopped_by (met r))
    @ [ Verdict.Unevaluated (Lost.stopped r.lost stop) ]
  in
  Result.map_error why (r.surroundings.attempt.run Concluding f)

let cut_short r temporal =
  match r.surroundings.stop () with
  | Some stop when Formulas.is_cut_short (formulas temporal) -> [ Verdict.Unevaluated (Lost.stopped r.lost stop) ]
  | Some _ | None -> []

let first r reason =
  let rec find states =
    match states () with
    | Seq.Nil -> None
    | Cons ((i, found), rest) -> if found == reason then Some i else find rest
  in
  if Graph.left_for r.graph reason = 0 then None else find (Graph.unexpanded r.graph)

(* How many states there are, and the nearest of them, in steps. *)
let counted r states =
  let nearer (count, best) j =
    match best with
    | Some i when Graph.depth r.graph i <= Graph.depth r.graph j -> (count + 1, best)
    | Some _ | None -> (count + 1, Some j)
  in
  Seq.fold_left nearer (0, None) states

(* Why no answer was found in some states. They may have been left because all was decided, only if then the time
   was over before it was decided again: to leave them out else would make more of an answer than was explored. *)
let causes ?(cut_short = false) r states : Verdict.reason list =
  let bound = function
    | Bounds.Early when not cut_short ->
      Scc_base.Bug.fail __POS__ "an open question did not keep the exploration going"
    | cause -> bound cause
  in
  let fault = function Bounds.Fault f -> Some f.Scc_base.Diag.message | Bound _ | Early -> None in
  let causes = List.map (cause r) (reasons r states) in
  let bounds = Verdict.distinct (List.filter_map bound causes) in
  let faults = List.sort_uniq String.compare (List.filter_map fault causes) in
  List.map (fun t -> Verdict.Truncated t) bounds @ List.map (fun text -> Verdict.Fault text) faults

(* With a run to the nearest of them. They may be too many to be counted in time, and the run may be long, and take
   as long to be made as to be found. *)
let unexplored ?cut_short r states =
  let matter =
    match Lost.attempt r.lost (fun () -> counted r states) with
    | None | Some (_, None) -> None
    | Some (count, Some i) ->
      run r (fun () -> Some (Make_witness.of_path r.context r.graph i))
      |> Option.map (fun nearest -> Verdict.Unexplored { count; nearest })
  in
  causes ?cut_short r states @ Option.to_list matter

let undefined (d : Search.doubts) = List.map (fun text -> Verdict.Undefined text) (Option.to_list d.undefined)
let search_doubts r (d : Search.doubts) = undefined d @ unexplored r d.unexplored

let doubts r temporal (d : Scc_ctl.Doubts.t) =
  let undefined =
    List.map (fun (u : Scc_ctl.Doubts.undefined) -> u.reason) d.undefined |> List.sort_uniq String.compare
  in
  List.map (fun text -> Verdict.Undefined text) undefined
  @ unexplored ~cut_short:(Formulas.is_cut_short (formulas temporal)) r (List.to_seq d.unexplored)
