open Scc_base
open Scc_semantics
open Scc_symbolic
open Scc_verify

type t = {
  semantics : Semantics.t;
  graph : Zone_graph.t;
  stopped_by : Verdict.truncation list;
  faults : Diag.t list;
}

let model s = Semantics.model s.semantics

let sum s f =
  let rec from i n = if i = Zone_graph.size s.graph then n else from (i + 1) (n + f (Zone_graph.node s.graph i)) in
  from 0 0

let unexpanded s = sum s (fun n -> if n.expanded then 0 else 1)
let edges s = sum s (fun n -> List.length n.edges)
let complete s = unexpanded s = 0 && s.stopped_by = []

let roots s =
  let number (n : Zone_graph.node) = n.number in
  List.sort_uniq Int.compare (List.map number (Zone_graph.roots s.graph))

let rests (n : Zone_graph.node) =
  let rest (c : _ First.cell) = if Option.is_none c.time then Some c.region else None in
  List.filter_map rest n.cells

let of_start (options : Setup.t) context zones =
  let bounds = options.bounds in
  let stop = ref None and is_late = ref false and size = ref 0 in
  let stopped () =
    stop := options.surroundings.stop ();
    Option.is_some !stop
  in
  let attempt work =
    match options.surroundings.attempt.run Exploring work with
    | Ok () -> true
    | Error reason ->
      stop := Some reason;
      false
  in
  let progress (node : Zone_graph.node) =
    let waiting = !size - node.number - 1 and model_time = lazy (Scc_state_sets.Zone.earliest node.zone) in
    options.surroundings.progress
      (Explored { states = !size; transitions = 0; waiting; depth = node.depth; model_time })
  in
  let visitor : Zone_graph.visitor =
    {
      found = (fun _ -> incr size);
      expanded = progress;
      late = (fun _ -> is_late := true);
      enough = (fun _ -> false);
      stop = stopped;
    }
  in
  let depth = Zone_bounds.depth bounds in
  let most = match depth.limit with Depth d -> d | _ -> Zone_bounds.default_depth in
  let horizon = Bounds.value bounds.time in
  let nodes = Bounds.value bounds.states in
  let limits = { Zone_graph.depth = Some most; nodes; horizon; later = Followed 0 } in
  let graph, end_ = Zone_graph.explore ~attempt context ~events:[||] ~limits ~visitor zones in
  let stopped_by : Verdict.truncation list =
    match end_ with
    | Closed | Decided | Not_affine _ -> []
    | Bounded { depth = deep; nodes } ->
      (if deep then [ depth ] else []) @ if nodes then [ Zone_bounds.states bounds ] else []
    | Stopped -> List.map (Bounds.stopped bounds) (Option.to_list !stop)
  in
  let late : Verdict.truncation list =
    match horizon with Some h when !is_late -> [ { limit = Time h; origin = By_user } ] | Some _ | None -> []
  in
  let faults =
    match end_ with
    | Not_affine reason ->
      [ Diag.error Code.not_yet Span.none "what is not known of this model does not stay linear: %s" reason ]
    | Closed | Decided | Bounded _ | Stopped -> []
  in
  { semantics = context.Instant.semantics; graph; stopped_by = stopped_by @ late; faults }

let explore (options : Setup.t) semantics u ~declared =
  let context = Instant.context semantics in
  let initial =
    match Network.initial semantics declared with
    | Ok s -> s
    | Error _ -> Bug.fail __POS__ "a law of motion in a model with ranges"
  in
  let keeps_time =
    (Semantics.model semantics).keeps_time || Option.is_some (Bounds.value options.bounds.time)
  in
  Start.zones context u ~initial ~keeps_time
  |> Result.map (of_start options context)
  |> Result.map_error (fun { Start.at; reason } -> { Zone_check.at; reason })
