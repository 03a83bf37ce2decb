open Scc_base
open Scc_calculus
open Scc_semantics
open Scc_verify
open Scc_equivalence

type source = Model of { model : Scc_loading.Loaded.t; space : Explored.t } | File
type t = { path : string; source : source; graph : Graph.t Later.t; complete : bool }

let is_graph_file path = Filename.check_suffix path ".aut"

(* A graph of ten million transitions has some 300 MB. *)
let max_graph_bytes = 1024 * Memory.mib

(* The leaf of a process by which it is called: the least by name, since the order in which bodies are declared
   should not be seen. [renamed] is what a name means to the other side. *)
let representative (space : Explored.t) ~renamed state leaf =
  let name l = renamed (Explored.model space).leaves.(l).Model.name in
  let first best (l : State.leaf) = if String.compare (name l.leaf) (name best) < 0 then l.leaf else best in
  match State.home state leaf with
  | Some process -> Array.fold_left first leaf process.leaves
  | None -> leaf

let label_text (space : Explored.t) ~renamed s (label : Transition.label) =
  let label : Transition.label =
    match label with
    | Bounce { firsts; _ } ->
      let state = space.state s in
      Bounce { firsts = List.map (representative space ~renamed state) firsts; hits = [] }
    | Absorb { first; absorber } ->
      Absorb { first = representative space ~renamed (space.state s) first; absorber }
    | Draw d -> Draw { d with first = representative space ~renamed (space.state s) d.first }
    | Time _ | Bind _ | Close _ | Weak_split _ | Strong_split _ | Lot _ -> label
  in
  Transition.label_to_string (Explored.model space) label

let graph_of_space ?(renamed = Fun.id) (space : Explored.t) =
  let b = Graph.builder () in
  for s = 0 to space.size - 1 do
    Array.iter
      (fun (e : Explored.edge) ->
         let label = Graph.intern b (label_text space ~renamed s e.label) in
         Graph.add b ~source:s ~label ~target:e.target)
      (space.edges s);
    if space.rests s then
      Graph.add b ~source:s ~label:(Graph.intern b (Label.of_passing Forever)) ~target:s
  done;
  Graph.finish b ~size:space.size ~initial:0 ~unknown:(fun s -> not (space.expanded s))

let load_graph console (attempt : Scc_graph_search.Limits.attempt) path =
  match Input.read ~max_bytes:max_graph_bytes console path with
  | Error d -> Error [ d ]
  | Ok source -> (
      match attempt.run Concluding (fun () -> Aut.read ~file:path (Source.text source)) with
      | Ok (Ok graph) ->
        Ok { path; source = File; graph = Later.make (fun () -> graph); complete = Graph.complete graph }
      | Ok (Error d) ->
        Console.add_source console source;
        Error [ d ]
      | Error stop -> raise (Scc_system.Interruption.Interrupted (Watch.reason stop ^ "; a graph was not read")))

let load_model console options ?renamed ~overrides path =
  let* model = Input.model console ~overrides path in
  let* model = Scc_loading.Ordinary.refuse model in
  Console.report console model.warnings;
  let* initial = Scc_loading.Loaded.initial model in
  let space = Explored.explore options model.semantics ~initial in
  Console.progress_done console;
  Input.report console model (space.faults @ space.dead_ends);
  let rec known s = s = space.size || (space.expanded s && known (s + 1)) in
  let graph = Later.make (fun () -> graph_of_space ?renamed space) in
  Ok { path; source = Model { model; space }; graph; complete = known 0 }

let load console options ?renamed ~overrides path =
  if is_graph_file path then
    if overrides = [] then load_graph console options.Setup.surroundings.attempt path
    else
      Error
        [
          Diag.error Code.unknown_parameter Span.command_line
            "%s is a graph, and has no parameters that could be given a value" path;
        ]
  else load_model console options ?renamed ~overrides path

let stopped_by t = match t.source with Model { space; _ } -> space.stopped_by | File -> []

let size t =
  match t.source with
  | File ->
    let graph = Later.force t.graph in
    (graph.size, Graph.edges graph)
  | Model { space; _ } -> (space.size, Explored.transitions space)
