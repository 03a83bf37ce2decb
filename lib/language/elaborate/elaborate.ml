open Scc_base
open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_property

type t = {
  name : string option;
  parameters : (string * Rat.t) list;
  templates : (string * Polyhedron.t) list;
  model : Model.t;
  declared : State.t;
  uncertain : Uncertain.t option;
  checks : Property.check list;
  premises : Property.check list;
  warnings : Diag.t list;
}

(* The behaviour of a leaf; nil for a fixed one without, and where there are faults. *)
let behaviour behaviours (l : Bodies.leaf) =
  match l.behaviour with
  | None -> Behaviour.nil
  | Some (env, b) ->
    let owner = { Behaviours.name = l.name; shape = l.shape; span = l.span } in
    Option.value ~default:Behaviour.nil (Behaviours.term behaviours env owner b)

let behaviours_of table (bodies : Bodies.t) keep =
  Array.to_list bodies.leaves
  |> List.mapi (fun i leaf -> (i, leaf))
  |> List.filter (fun (i, _) -> keep i)
  |> List.map (fun (_, leaf) -> Option.fold ~none:Behaviour.nil ~some:(behaviour table) leaf)

let warn_unused (c : Context.t) (program : Program.t) =
  let warn what name at = Report.warning c.report Code.unused at "the %s `%s` is not used" what name in
  Hashtbl.iter
    (fun name (t : Context.template) -> if t.own && not t.used then warn "template" name t.span)
    c.templates;
  Hashtbl.iter
    (fun name (f : Context.family) ->
       if f.family_own && f.instances = 0 then warn "template" name f.family_span)
    c.families;
  Hashtbl.iter
    (fun name (b : Program.behaviour) -> if Env.is_own b.env && not b.used then warn "behaviour" name b.name.at)
    program.behaviours;
  List.iter
    (fun (what, name, (b : Env.binding)) -> if not b.used then warn what name b.span)
    program.values

let templates (c : Context.t) (program : Program.t) =
  let basic name =
    match Hashtbl.find_opt c.templates name with
    | Some { shape = Some (Basic b); _ } -> Some (name, b.polyhedron)
    | Some { shape = Some (Compound _) | None; _ } | None -> None
  in
  List.filter_map basic program.shapes

let is_steered (l : Model.leaf) = not (l.fixed || Law.is_inertial l.law)

(* Everything is in order. *)
let build (c : Context.t) (program : Program.t) bodies composition joints initial written checks premises =
  let definitions = Behaviour.canonical_definitions written in
  let initial = Array.map (Behaviour.canonical written) initial in
  let leaves = Assembly.leaves bodies composition in
  let rigid = Settings.rigid program.settings c.report ~spinning:(Assembly.spinning bodies composition) leaves in
  let steered = Array.exists is_steered leaves in
  let keeps_time =
    Array.exists (fun (l : Model.leaf) -> Law.mentions_time l.law) leaves
    || List.exists (fun (k : Property.check) -> Formula.mentions_time k.formula) checks
  in
  let model =
    {
      Model.leaves;
      definitions;
      timestep = program.timestep;
      splits = program.splits;
      ranges = program.ranges;
      keeps_time;
      steered;
      steps = program.steps;
      collisions = Settings.collisions program.settings;
      binding = Settings.binding program.settings;
      bonds = Settings.bonds program.settings;
      round_velocity = Settings.round_velocity program.settings;
      lots = false;
      rigid;
    }
  in
  let declared = Assembly.state bodies composition joints initial model in
  let model = { model with lots = Parameters.has_lots model declared } in
  {
    name = program.name;
    parameters = program.parameters;
    templates = templates c program;
    model;
    declared;
    uncertain = Assembly.uncertain bodies composition program.ranges;
    checks;
    premises;
    warnings = Report.warnings c.report;
  }

(* What nothing uses has been read by nobody. Those that use others come first. *)
let check_unused_lets formulas (program : Program.t) =
  List.iter
    (fun (_, _, (b : Env.binding)) ->
       match b.value with
       | Macro (e, env) when not b.used -> Formulas.check_let formulas env e
       | Macro _ | Number _ | Truth _ | Vector _ | Affine _ | Word _ | Leaf _ | Unknown -> ())
    (List.rev program.values)

let read c (program : Program.t) =
  let bodies = Bodies.read c program.bodies in
  let composition = Composition.read c program bodies in
  let table = Behaviours.create c program in
  let included i = composition.included.(i) in
  let initial = Array.of_list (behaviours_of table bodies included) in
  let joints = Joints.read c program bodies composition in
  List.iter (fun (j : Joints.t) -> Behaviours.use_channel table j.name) joints;
  Behaviours.settle table;
  let formulas = Formulas.create c bodies composition table in
  let checks = List.filter_map (Formulas.check formulas) program.checks in
  let premises =
    if Report.failed c.report then [] else List.concat_map (Formulas.premises formulas) program.checks
  in
  Behaviours.seal table;
  check_unused_lets formulas program;
  ignore (behaviours_of table bodies (fun i -> not (included i)));
  Templates.read_unused c;
  let definitions = Behaviours.finish table in
  Assembly.check_overlaps c bodies composition;
  if not (Report.failed c.report) then
    Settings.check program.settings c.report ~spins:(Option.is_some (Assembly.spinning bodies composition));
  Templates.warn_off_centre c;
  warn_unused c program;
  if Report.failed c.report then None
  else Some (build c program bodies composition joints initial definitions checks premises)

let elaborate ~read_file ~overrides ?(narrowed = []) syntax =
  let c = Context.create ~read_file in
  Limits.check_depth c.report syntax;
  let program = if Report.failed c.report then None else Program.read c ~overrides ~narrowed syntax in
  let result = Option.bind program (read c) in
  match result with
  | Some t -> Ok t
  | None -> Error (Report.errors c.report)
