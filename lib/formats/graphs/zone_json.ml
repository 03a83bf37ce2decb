open Scc_polyhedra
open Scc_calculus
open Scc_property
open Scc_offsets
open Scc_state_sets
open Scc_symbolic
open Scc_zones
open Scc_json
open Scc_runs
open Scc_reports

let version = 1
let names n name = List.init n (fun i -> Json.text (name i))
let polyhedron = Where_json.polyhedron_of
let list encode array = `List (List.map encode (Array.to_list array))

let leaf m ~name (z : Zone.t) (l : State.leaf) =
  let form = Where_json.form ~name in
  let origin k = Json.text m.Model.definitions.(k).name in
  `Assoc
    [
      ("name", Json.text m.leaves.(l.leaf).name);
      ("position", `List (List.map form (Place.coordinates z.places.(l.leaf))));
      ("behaviour", Json.text (State_json.behaviour m ~leaf:l.leaf l.behaviour));
      ("origin", Json.option origin l.behaviour.origin);
      ("age", form z.ages.(l.leaf));
    ]

let process m ~name (z : Zone.t) (p : State.process) =
  let clock = Option.map (fun _ -> z.clocks.(p.leaves.(0).leaf)) p.clock in
  `Assoc
    [
      ("velocity", Json.vec p.velocity);
      ("clock", Json.option (Where_json.form ~name) clock);
      ("leaves", list (leaf m ~name z) p.leaves);
      ("bonds", list (fun b -> `Assoc (State_json.bond m b)) p.bonds);
    ]

let edge m ~name (target : int -> Zone.t) (e : Zone_graph.edge) =
  let time text duration =
    `Assoc [ ("kind", `String "time"); ("text", Json.text text); ("duration", Where_json.form ~name duration) ]
  in
  let label =
    match e.step with
    | Happens l -> State_json.label m l
    | Passes f -> time (Printf.sprintf "time(%s)" (Text.form ~name f)) f
    | Passes_some ->
      let n = Polyhedron.dimension e.guard in
      time "time(time passed)" (Linear.variable n (n - 1))
  in
  let becomes = Zone_names.variable m (target e.target) in
  let given i f = (becomes i, Where_json.form ~name f) in
  `Assoc
    [
      ("label", label);
      ("guard", polyhedron ~name (Polyhedron.minimal e.guard));
      ("target", `Int e.target);
      ("map", `Assoc (Array.to_list (Array.mapi given e.map)));
    ]

let node (s : Zone_space.t) (n : Zone_graph.node) =
  let m = Zone_space.model s in
  let z = n.zone in
  let name = Zone_names.variable m z in
  let form = Where_json.form ~name in
  let parameter i f = (Ranges.name m.ranges i, form f) in
  let target i = (Zone_graph.node s.graph i).zone in
  let gone = State.gone m z.skeleton in
  `Assoc
    [
      ("number", `Int n.number);
      ("depth", `Int n.depth);
      ("status", `String (if n.expanded then "expanded" else "unexplored"));
      ("halted", `Bool z.halted);
      ("variables", `List (names (Zone.dimension z) name));
      ("where", Json.text (Text.polyhedron ~name z.set));
      ("polyhedron", polyhedron ~name z.set);
      ("parameters", `Assoc (Array.to_list (Array.mapi parameter z.parameters)));
      ("time", Json.option form z.time);
      ("processes", list (process m ~name z) z.skeleton.processes);
      ("gone", `List (List.map (fun leaf -> Json.text m.leaves.(leaf).name) gone));
      ("rests", `List (List.map (polyhedron ~name) (Zone_space.rests n)));
      ("late", `List (List.map (fun p -> polyhedron ~name (Polyhedron.minimal p)) n.late));
      ("edges", `List (List.map (edge m ~name target) n.edges));
    ]

let write (e : Zone_exported.t) put =
  let space = e.space in
  let add key json = put (Json.line (`String key) ^ ": " ^ Json.line json ^ ",\n") in
  let texts list = `List (List.map Json.text list) in
  let check (c : Property.check) = `Assoc [ ("name", Json.text c.name); ("text", Json.text c.text) ] in
  let ranges = e.loaded.model.ranges in
  let size = Zone_graph.size space.graph in
  put "{\n";
  add "format" (`String "scc-zones");
  add "version" (`Int version);
  add "semantics" (`String Parameters.version);
  List.iter (fun (key, json) -> add key json) (Origin_json.members e.loaded.origin);
  add "ranges" (texts (List.map Ranges.range_to_string (Array.to_list ranges)));
  add "range" (polyhedron ~name:(Ranges.name ranges) (Ranges.box ranges));
  add "complete" (`Bool (Zone_space.complete space));
  add "unexplored" (`Int (Zone_space.unexpanded space));
  add "bounds" (texts (Zone_exported.bounds e));
  add "faults" (texts (List.map (fun (f : Scc_base.Diag.t) -> f.message) space.faults));
  add "checks" (`List (List.map check e.loaded.checks));
  let roots = Zone_space.roots space in
  add "roots" (`List (List.map (fun i -> `Int i) roots));
  put "\"zones\": [\n";
  for i = 0 to size - 1 do
    put (Json.line (node space (Zone_graph.node space.graph i)) ^ if i = size - 1 then "\n" else ",\n")
  done;
  put "]\n}\n"
