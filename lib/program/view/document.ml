open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_loading
open Scc_json
open Scc_runs

type t = {
  loaded : Loaded.t;
  name : string;
  tables : Tables.t;
  states : States.t;
  plots : Property.num list;
  graph : Graph.t option;
  runs : Json.t list;
  where : Json.t option;
}

let graph (g : Graph.t) =
  `Assoc
    [
      ("states", `Int g.states);
      ("expanded", `Int g.expanded);
      ("complete", `Bool g.complete);
      ("bound", `Int g.bound);
    ]

let rules model =
  let one r = Option.map (fun text -> (Rule.id r, Json.text text)) (Rule_texts.find (Rule.id r)) in
  `Assoc (List.filter_map one (Rule.of_model model))

let write d put =
  let m = d.loaded.model in
  let origin = d.loaded.origin in
  let first = ref true in
  let member name write =
    put (if !first then "{" else ",\n");
    first := false;
    put (Json.line (`String name) ^ ":");
    write put
  in
  let json name value = member name (fun put -> put (Json.line value)) in
  let plot n = `Assoc [ ("text", Json.text (Show.num m n)) ] in
  json "format" (`String "scc-view");
  json "version" (`Int 1);
  json "semantics" (`String Parameters.version);
  List.iter (fun (name, value) -> json name value) (Origin_json.members origin);
  json "name" (Json.text d.name);
  json "text" (Json.text (Scc_base.Source.text d.loaded.source));
  json "timestep" (Json.rat m.timestep);
  json "resolution" (Json.option Json.rat (Model.resolution m));
  json "families" (Bodies.families m);
  json "leaves" (Bodies.leaves ~solids:d.tables.solids m);
  json "plots" (`List (List.map plot d.plots));
  json "graph" (Json.option graph d.graph);
  json "rules" (rules m);
  json "where" (Json.option Fun.id d.where);
  member "runs" (fun put ->
      put "[";
      List.iteri (fun i run -> put ((if i = 0 then "\n" else ",\n") ^ Json.line run)) d.runs;
      put "]");
  member "solids" (Rows.write d.tables.solids);
  member "behaviours" (Rows.write d.tables.behaviours);
  member "labels" (Rows.write d.tables.labels);
  member "processes" (Rows.write d.tables.processes);
  member "states" (States.write d.states);
  put "}\n"
