open Scc_polyhedra
open Scc_calculus
open Scc_offsets
open Scc_state_sets
open Scc_symbolic
open Scc_zones
open Scc_json
open Scc_runs
open Scc_reports
open Json_format

let form = Where_json.form_format
let polyhedron = Where_json.polyhedron_format

(* A zone of a model. What is within it comes with it: the names of its variables are its own. *)
type of_zone = { model : Model.t; zone : Zone.t; name : int -> string }

let of_zone model zone = { model; zone; name = Zone_names.variable model zone }
let named_by z f x = (z.name, f x)
let all_of z array = List.map (fun x -> (z, x)) (Array.to_list array)

let leaf =
  let leaf_form f (z, (l : State.leaf)) = (z.name, f z.zone l.leaf) in
  let place (z, (l : State.leaf)) =
    List.map (named_by z Fun.id) (Place.coordinates z.zone.places.(l.leaf))
  in
  let behaviour (z, (l : State.leaf)) = State_json.behaviour z.model ~leaf:l.leaf l.behaviour in
  let origin (z, (l : State.leaf)) = Option.map (fun k -> z.model.definitions.(k).name) l.behaviour.origin in
  fields
    [
      field "name" some_text (fun (z, (l : State.leaf)) -> z.model.leaves.(l.leaf).name);
      field "position" (list ~least:3 ~most:3 form) place ~about:"x, y, z in the world.";
      field "behaviour" some_text behaviour
        ~about:"As it was when it was last set, in the syntax of the language.";
      field "origin" (nullable text) origin;
      field "age" form (leaf_form (fun zone leaf -> zone.ages.(leaf)))
        ~about:"For how long the behaviour has aged since.";
    ]

let process =
  let clock (z, (p : State.process)) =
    Option.map (fun _ -> (z.name, z.zone.clocks.(p.leaves.(0).leaf))) p.clock
  in
  fields
    [
      field "velocity" Shared.vector (fun (_, (p : State.process)) -> p.velocity);
      field "clock" (nullable form) clock
        ~about:
          "Time since the split clock was set, 0 with split_step any; null when no weak split is enabled.";
      field "leaves" (list ~least:1 leaf) (fun (z, (p : State.process)) -> all_of z p.leaves);
      field "bonds" (list State_json.bond_format) (fun (z, (p : State.process)) ->
          List.map (fun (z, b) -> (z.model, b)) (all_of z p.bonds));
    ]

(* {1 Edges} *)

let passing (z, (e : Zone_graph.edge)) =
  match e.step with
  | Happens _ -> None
  | Passes f -> Some (Printf.sprintf "time(%s)" (Text.form ~name:z.name f), (z.name, f))
  | Passes_some ->
    let n = Polyhedron.dimension e.guard in
    Some ("time(time passed)", (z.name, Linear.variable n (n - 1)))

let label =
  let happening (z, (e : Zone_graph.edge)) =
    match e.step with Happens l -> Some (z.model, l) | Passes _ | Passes_some -> None
  in
  let time = `String "time" in
  let is_time json =
    match Json.member "kind" json with Some (`String "time") -> Some "is a passing of time" | _ -> None
  in
  let no_time = [ ("properties", `Assoc [ ("kind", `Assoc [ ("not", `Assoc [ ("const", time) ]) ]) ]) ] in
  union
    [
      case (fields [ fixed "kind" time; field "text" some_text fst; field "duration" form snd ]) passing Fun.id;
      case (constrained no_time is_time State_json.label_format) happening Fun.id;
    ]

let edge =
  let target ((z, e), _) = (z, e) in
  let map ((z, (e : Zone_graph.edge)), after) =
    let becomes = Zone_names.variable z.model after in
    Array.to_list (Array.mapi (fun i f -> (becomes i, (z.name, f))) e.map)
  in
  fields
    [
      field "label" label target
        ~about:
          "Of a passing of time the duration is a form: until what comes next or, where it is the variable `time \
           passed`, any time that the guard allows, to a zone that is halted.";
      field "guard" polyhedron (fun ((z, (e : Zone_graph.edge)), _) -> (z.name, Polyhedron.minimal e.guard))
        ~about:"From where the edge is taken: over the variables of the zone, and `time passed`.";
      field "target" natural (fun ((_, (e : Zone_graph.edge)), _) -> e.target);
      field "map" (entries form) map ~about:"The variables of the target, as forms over those of the guard.";
    ]

(* {1 Zones} *)

let zone =
  let in_zone f (z, _, _) = f z in
  let in_node f (_, (n : Zone_graph.node), _) = f n in
  let variables z = List.init (Zone.dimension z.zone) z.name in
  let parameters z =
    Array.to_list (Array.mapi (fun i f -> (Ranges.name z.model.ranges i, (z.name, f))) z.zone.parameters)
  in
  let gone z = List.map (fun leaf -> z.model.leaves.(leaf).name) (State.gone z.model z.zone.skeleton) in
  let status (n : Zone_graph.node) = if n.expanded then "expanded" else "unexplored" in
  let polyhedra f (z, n, _) = List.map (named_by z Fun.id) (f n) in
  let late (n : Zone_graph.node) = List.map Polyhedron.minimal n.late in
  let edges (z, (n : Zone_graph.node), graph) =
    List.map (fun (e : Zone_graph.edge) -> ((z, e), (Zone_graph.node graph e.target).zone)) n.edges
  in
  fields
    [
      field "number" natural (in_node (fun n -> n.number));
      field "depth" natural (in_node (fun n -> n.depth))
        ~about:"How many edges lead there from the start, at least.";
      field "status" (word Fun.id [ "expanded"; "unexplored" ]) (in_node status)
        ~about:"unexplored: its edges are not known.";
      field "halted" bool (in_zone (fun z -> z.zone.halted))
        ~about:"Time has stopped here for a weak split, which is all that may happen.";
      field "variables" (list ~distinct:true some_text) (in_zone variables)
        ~about:
          "The numbers of its states that the others depend on: parameters, `model time`, age(p), clock(p), x(p), \
           y(p), z(p).";
      field "where" some_text (in_zone (fun z -> Text.polyhedron ~name:z.name z.zone.set))
        ~about:"The polyhedron, for people.";
      field "polyhedron" polyhedron (in_zone (fun z -> (z.name, z.zone.set)))
        ~about:"The values of the variables.";
      field "parameters" (entries form) (in_zone parameters);
      field "time" (nullable form) (in_zone (fun z -> Option.map (named_by z Fun.id) z.zone.time))
        ~about:"Since the start; null where it is not kept.";
      field "processes" (list process) (in_zone (fun z -> all_of z z.zone.skeleton.processes));
      field "gone" (list some_text) (in_zone gone) ~about:"Who has been absorbed.";
      field "rests" (list polyhedron) (polyhedra Zone_space.rests)
        ~about:"From where nothing comes next: time may pass for ever. Disjoint.";
      field "late" (list polyhedron) (polyhedra late)
        ~about:"From where what comes next is later than the bound of time.";
      field "edges" (list edge) edges;
    ]

(* {1 The document} *)

let head =
  let space f (e : Zone_exported.t) = f e.space in
  let ranges f (e : Zone_exported.t) = f e.loaded.model.ranges in
  let faults (s : Zone_space.t) = List.map (fun (f : Scc_base.Diag.t) -> f.message) s.faults in
  all
    (Shared.head "scc-zones" 1
     @ [
       Shared.semantics ();
       within (fun (e : Zone_exported.t) -> e.loaded.origin) Origin_json.fields;
       field "ranges" (list some_text)
         (ranges (fun r -> List.map Ranges.range_to_string (Array.to_list r)))
         ~about:"The parameters that are known by ranges, for people.";
       field "range" polyhedron (ranges (fun r -> (Ranges.name r, Ranges.box r))) ~about:"All their values.";
       field "complete" bool (space Zone_space.complete) ~about:"All edges of all zones are there.";
       field "unexplored" natural (space Zone_space.unexpanded)
         ~about:"How many zones have edges that are not known.";
       field "bounds" Shared.texts Zone_exported.bounds ~about:"The bounds that left something out, in words.";
       field "faults" Shared.texts (space faults) ~about:"Why what comes of some zone is not known.";
       field "checks" (list Graph_json.check) (fun (e : Zone_exported.t) -> e.loaded.checks);
       field "roots" (list ~least:1 natural) (space Zone_space.roots)
         ~about:"The numbers of the zones of the start.";
     ])

let document =
  let get (e : Zone_exported.t) =
    let model = Zone_space.model e.space and graph = e.space.graph in
    let one i =
      let node = Zone_graph.node graph i in
      (of_zone model node.zone, node, graph)
    in
    (Zone_graph.size graph, one)
  in
  { Long_document.head; rows = "zones"; about = "In the order in which they were found."; row = zone; get }

let format = Long_document.format document
let write = Long_document.write document
