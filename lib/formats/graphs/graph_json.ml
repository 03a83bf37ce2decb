open Scc_property
open Scc_verify
open Scc_json
open Scc_runs

let version = 1

let status : Labelling.status -> string = function
  | Moves -> "expanded"
  | Rests -> "quiescent"
  | Stuck -> "stuck"
  | Unexplored -> "unexplored"

let text = Json.text
let texts list = `List (List.map text list)

let member put ?(last = false) key value =
  put (Json.line (`String key) ^ ": " ^ value ^ if last then "\n" else ",\n")

let predicate l k (p : State_predicates.t) =
  `Assoc
    [
      ("name", text p.name);
      ("text", text p.text);
      ("changes", `Int (Labelling.changes l k));
      ("undecided", Json.option (fun (_, why) -> text why) (Labelling.undecided l k));
    ]

let check (c : Property.check) = `Assoc [ ("name", text c.name); ("text", text c.text) ]

let edge model (e : Explored.edge) =
  `Assoc [ ("label", State_json.label model e.label); ("target", `Int e.target) ]

let state l i =
  let space = Labelling.space l in
  let holding =
    List.filteri (fun k _ -> Labelling.holds l i k) (Array.to_list (Labelling.predicates l))
  in
  `Assoc
    [
      ("number", `Int i);
      ("status", `String (status (Labelling.status l i)));
      ("holds", texts (List.map (fun (p : State_predicates.t) -> p.name) holding));
      ("state", State_json.state (Explored.model space) (space.state i));
      ("edges", `List (List.map (edge (Explored.model space)) (Array.to_list (space.edges i))));
    ]

let write (e : Exported.t) l put =
  let space = e.space in
  let predicates = Array.to_list (Array.mapi (predicate l) (Labelling.predicates l)) in
  let bounds = List.map Verdict.truncation_to_string space.stopped_by in
  let add ?last key json = member put ?last key (Json.line json) in
  put "{\n";
  add "format" (`String "scc-graph");
  add "version" (`Int version);
  add "semantics" (`String Scc_calculus.Parameters.version);
  List.iter (fun (key, json) -> add key json) (Origin_json.members e.loaded.origin);
  add "complete" (`Bool (Explored.complete space));
  add "unexplored" (`Int (Explored.unexpanded space));
  add "bounds" (texts bounds);
  add "faults" (texts (List.map (fun (f : Scc_base.Diag.t) -> f.message) space.faults));
  add "checks" (`List (List.map check e.loaded.checks));
  add "predicates" (`List predicates);
  put "\"states\": [\n";
  for i = 0 to space.size - 1 do
    put (Json.line (state l i) ^ if i = space.size - 1 then "\n" else ",\n")
  done;
  put "]\n}\n"
