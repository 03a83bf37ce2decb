open Scc_base
open Scc_exact
open Scc_polyhedra
open Scc_graph_search
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_state_sets
open Scc_symbolic
open Scc_verify

type t = {
  group : Zone_groups.t;
  graph : Zone_graph.t;
  answers : Answers.t list;
  met : Answers.t list;  (** of the premises *)
  uneventful : bool;  (** all is known, and nothing ever happens *)
  stopped_by : Verdict.truncation list;
  unevaluated : Verdict.truncation option;
  fault : string option;
  decided : bool;
  edges : int;
  proof : By_invariant.end_ option;
}

let progress (options : Setup.t) ~size (node : Zone_graph.node) =
  let waiting = size - node.number - 1 and model_time = lazy (Zone.earliest node.zone) in
  options.surroundings.progress
    (Explored { states = size; transitions = 0; waiting; depth = node.depth; model_time })

let proofs_of answers = function
  | Some (By_invariant.Proved { proofs; _ }) -> List.map Option.some proofs
  | Some (None_found _ | Given_up _) | None -> List.map (fun _ -> None) answers

(* With what is proved. *)
let sets answer (proof : Proof.t option) =
  let { Answers.holds; fails } = Answers.sets answer in
  match proof with
  | None -> { Answers.holds; fails }
  | Some { sets; _ } ->
    let contradict a b = not (Union.is_empty (Union.inter a b)) in
    if contradict holds sets.fails || contradict fails sets.holds then
      Bug.fail __POS__ "what an invariant proves is wrong";
    { holds = Union.union holds sets.holds; fails = Union.union fails sets.fails }

let is_proved ~exactly all (proof : Proof.t option) =
  match proof with
  | None -> false
  | Some { sets = { holds; fails }; _ } ->
    let left = Union.difference (Union.difference all holds) fails in
    Union.is_empty left || ((not exactly) && not (Union.is_empty fails))

(* {2 What a visitor meets} *)

(* Filled while the graph is explored. *)
type visited = {
  mutable size : int;  (** nodes found so far *)
  mutable late : bool;  (** a zone lies beyond the bound of time of the user *)
  mutable beyond : bool;  (** a zone lies beyond the horizon *)
  mutable stop : Limits.stop option;
}

type horizon = {
  time : Rat.t option;
  later : Zone_graph.later;
  by_user : bool;  (** it is the bound of the user *)
}

(* The time up to which zones are explored, and what becomes of later ones. *)
let horizon (options : Setup.t) (group : Zone_groups.t) looking =
  let asked = if group.keeps_time then Plan.latest (List.map Answers.reach looking) else None in
  match (asked, Bounds.value options.bounds.time) with
  | Some { time; events = 0 }, Some b when Rat.compare time b <= 0 ->
    { time = Some time; later = Followed 0; by_user = false }
  | _, (Some _ as time) ->
    { time; later = (if List.for_all Answers.is_search looking then Followed 0 else Unexplored); by_user = true }
  | Some { time; events }, None -> { time = Some time; later = Followed events; by_user = false }
  | None, None -> { time = None; later = Followed 0; by_user = false }

let visitor (options : Setup.t) visited ~by_user ~looking ~enough : Zone_graph.visitor =
  {
    found = (fun _ -> visited.size <- visited.size + 1);
    expanded =
      (fun node ->
         progress options ~size:visited.size node;
         List.iter (fun a -> Answers.look a node) looking);
    late =
      (fun zone ->
         visited.beyond <- true;
         if by_user then begin
           visited.late <- true;
           List.iter (fun a -> Answers.leave a zone) looking
         end);
    enough;
    stop =
      (fun () ->
         visited.stop <- options.surroundings.stop ();
         Option.is_some visited.stop);
  }

let iter_nodes graph f =
  for i = 0 to Zone_graph.size graph - 1 do
    f (Zone_graph.node graph i)
  done

(* The number of edges, and whether one of them is an event. *)
let count_edges graph =
  let edges = ref 0 and happens = ref false in
  let is_event (e : Zone_graph.edge) = match e.step with Happens _ -> true | Passes _ | Passes_some -> false in
  iter_nodes graph (fun node ->
      edges := !edges + List.length node.edges;
      happens := !happens || List.exists is_event node.edges);
  (!edges, !happens)

let bounds_met (options : Setup.t) visited (end_ : Zone_graph.end_) : Verdict.truncation list =
  (match end_ with
   | Closed | Decided | Not_affine _ -> []
   | Bounded { depth; nodes } ->
     (if depth then [ Zone_bounds.depth options.bounds ] else [])
     @ if nodes then [ Zone_bounds.states options.bounds ] else []
   | Stopped -> List.map (Bounds.stopped options.bounds) (Option.to_list visited.stop))
  @
  match Bounds.value options.bounds.time with
  | Some t when visited.late -> [ { limit = Time t; origin = By_user } ]
  | _ -> []

(* Where no bound of time ends what formulas look at, those that no search decides are evaluated when there are so
   many nodes, and four times as many each time. *)
let first_evaluation = 64

let explore (options : Setup.t) context (group : Zone_groups.t) ~initial zones ~ranges ~exactly ~proof =
  let formulas_of = List.map (fun (_, (c : Property.check)) -> c.formula) in
  let formulas = formulas_of (group.members @ group.premises) in
  let events = Scc_data.Lists.distinct Formula.equal_event (List.concat_map Formula.events formulas) in
  let events = Array.of_list events in
  let atoms = Atoms.context context ~events in
  let parameters = Ranges.box ranges in
  let answers_to numbered = List.map (Answers.make context atoms ~parameters) (formulas_of numbered) in
  let answers = answers_to group.members and met = answers_to group.premises in
  let looking = answers @ met in
  let proved = List.map (is_proved ~exactly (Union.of_polyhedron parameters)) (proofs_of answers proof) in
  let branching = List.filter (fun a -> not (Answers.is_search a)) looking in
  let evaluate stage graph =
    options.surroundings.attempt.run stage (fun () -> List.iter (fun a -> Answers.conclude a graph) branching)
  in
  let goes_on = Option.is_none (Plan.latest (List.map Answers.reach looking)) in
  let next = ref first_evaluation in
  let enough graph =
    if goes_on && branching <> [] && Zone_graph.size graph >= !next then begin
      next := 4 * !next;
      ignore (evaluate Exploring graph)
    end;
    answers <> [] && List.for_all2 (fun a proved -> proved || Answers.is_known ~exactly a) answers proved
  in
  let horizon = horizon options group looking in
  let depth = match (Zone_bounds.depth options.bounds).limit with Depth d -> d | _ -> Zone_bounds.default_depth in
  let nodes = Bounds.value options.bounds.states in
  let limits = { Zone_graph.depth = Some depth; nodes; horizon = horizon.time; later = horizon.later } in
  let visited = { size = 0; late = false; beyond = false; stop = None } in
  let model = Semantics.model context.Instant.semantics in
  let graph, end_ =
    Zone_graph.explore
      ~displaced:(Zone_reduction.displaced options model initial formulas)
      ?visible:(Zone_reduction.visible options formulas)
      ~interchangeable:(Zone_reduction.interchangeable options model initial formulas)
      context ~events ~limits
      ~visitor:(visitor options visited ~by_user:horizon.by_user ~looking ~enough)
      zones
  in
  iter_nodes graph (fun node ->
      if not node.expanded then List.iter (fun a -> Answers.look_around a node) looking);
  let is_closed = match end_ with Closed -> true | _ -> false in
  let unevaluated =
    match end_ with
    | Decided -> None
    | Closed | Bounded _ | Stopped | Not_affine _ ->
      let stop = match evaluate Concluding graph with Ok () -> None | Error stop -> Some stop in
      Option.map (Bounds.stopped options.bounds) stop
  in
  let edges, happens = count_edges graph in
  {
    group; graph; answers; met; edges; proof; unevaluated;
    uneventful = is_closed && not (happens || visited.beyond || Option.is_some group.part);
    stopped_by = bounds_met options visited end_;
    fault = (match end_ with Not_affine reason -> Some reason | _ -> None);
    decided = (match end_ with Decided -> true | _ -> false);
  }
