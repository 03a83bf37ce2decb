open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_loading
open Scc_json
open Scc_runs
open Json_format

type t = {
  loaded : Loaded.t;
  name : string;
  tables : Tables.t;
  states : States.t;
  plots : Property.num list;
  graph : Graph.t option;
  runs : Runs.t list;
  where : Regions.t option;
  spread : Spread.t option;
}

(* {1 All but the rows} *)

(* What the text itself defines outside loops; what imports define has names with a dot. *)
let lets source =
  let add found (item : Scc_syntax.Ast.item) =
    match item.it with
    | Let (name, e) -> (name.it, Scc_syntax.Printer.expr e) :: found
    | _ -> found
  in
  List.rev (List.fold_left add [] (Scc_notation.Notation.readable source))

let graph =
  fields
    [
      field "states" natural (fun (g : Graph.t) -> g.states);
      field "expanded" natural (fun (g : Graph.t) -> g.expanded);
      field "complete" bool (fun (g : Graph.t) -> g.complete);
      field "bound" natural (fun (g : Graph.t) -> g.bound);
    ]

let head =
  let model f (d, _) = f d.loaded.model in
  let plot = fields [ field "text" some_text (fun (m, n) -> Show.num m n) ] in
  let rules m =
    let one r = Option.map (fun text -> (Rule.id r, text)) (Rule_texts.find (Rule.id r)) in
    List.filter_map one (Rule.of_model m)
  in
  all
    (Shared.head "scc-view" 1
     @ [
       Shared.semantics ();
       within (fun (d, _) -> d.loaded.origin) Origin_json.fields;
       field "name" text (fun (d, _) -> d.name) ~about:"Of the file.";
       field "text" text (fun (d, _) -> Scc_base.Source.text d.loaded.source) ~about:"Of the model.";
       maybe "lets" (entries some_text)
         (fun (d, _) -> match lets d.loaded.source with [] -> None | all -> Some all)
         ~about:"What the model defines by `let` outside loops, as the language writes it.";
       field "timestep" Shared.rational (model (fun m -> m.timestep));
       field "resolution" (nullable Shared.rational) (model Model.resolution);
       field "families" (list some_text) (model (fun m -> Array.to_list (Families.of_model m).names))
         ~about:"Names of what looks alike; those of bodies that move come first.";
       field "leaves" (list Bodies.format) snd;
       field "plots" (list plot) (fun (d, _) -> List.map (fun n -> (d.loaded.model, n)) d.plots);
       field "graph" (nullable graph) (fun (d, _) -> d.graph)
         ~about:
           "How much of all that can happen is in the document; null: of a large network nothing but the run.";
       field "rules" (entries text) (model rules) ~about:"Entries of the rule book, in Markdown.";
       field "where" (nullable Regions.format) (fun (d, _) -> d.where)
         ~about:"Of a model with ranges: for which values checks hold.";
       maybe "spread" Spread.format (fun (d, _) -> d.spread)
         ~about:"Of runs of a simulation: the values of all its runs.";
     ])

(* {1 Rows} *)

(* An array that is written row by row. *)
type rows = { name : string; member : (t * Bodies.t list, unit) members; put : t -> (string -> unit) -> unit }

let rows name format put = { name; member = field name (list format) (fun _ -> []); put }

let write_runs d put =
  put "[";
  List.iteri (fun i run -> put ((if i = 0 then "\n" else ",\n") ^ Json.line (write Runs.format run))) d.runs;
  put "]"

let all_rows =
  [
    rows "runs" Runs.format write_runs;
    rows "solids" Bodies.solid_format (fun d -> Rows.write d.tables.solids);
    rows "behaviours" Tables.behaviour_format (fun d -> Rows.write d.tables.behaviours);
    rows "labels" Tables.label_format (fun d -> Rows.write d.tables.labels);
    rows "processes" Tables.process_format (fun d -> Rows.write d.tables.processes);
    rows "states" States.format (fun d -> States.write d.states);
  ]

let format =
  fields (head :: List.map (fun r -> r.member) all_rows)
  |> about
    "States, processes, behaviours, solids and labels are rows of tables, told by their numbers. A state is told \
     by what has changed since another one, so that a run takes space for what happens in it."

let write d put =
  let name name = Json.line (`String name) ^ ":" in
  let leaves = Bodies.leaves ~solids:d.tables.solids d.loaded.model in
  let members = List.map (fun (n, json) -> name n ^ Json.line json) (written_members head (d, leaves)) in
  put ("{" ^ String.concat ",\n" members);
  let array rows =
    put (",\n" ^ name rows.name);
    rows.put d put
  in
  List.iter array all_rows;
  put "}\n"
