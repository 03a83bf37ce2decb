open Scc_base
open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_property

type t = {
  name : string option;
  parameters : (string * Rat.t) list;
  templates : (string * Polyhedron.t) list;
  families : Repeated.t;
  model : Model.t;
  declared : State.t;
  uncertain : Uncertain.t option;
  parameter : Open_number.t option;
  checks : Property.check list;
  premises : Property.check list;
  lattices : Lattices.t list;
  warnings : Diag.t list;
  values : (Span.t * string) list;
  kept : kept;
}

(* What formulas need that are read later. *)
and kept = {
  program : Program.t;
  subjects : Formulas.t;  (* as they were after the checks of the text, with a context of their own *)
  ended : Context.t;  (* all of it has been read, but what warns of names that are not used *)
  own : Property.check list * Property.check list;  (* the checks of the text, and their premises *)
  added : Scc_syntax.Ast.model;  (* the checks that were read later *)
  whole : Scc_syntax.Ast.model -> (t, Diag.t list) result;  (* elaborates all of it, with these items at its end *)
}

(* The behaviour of a leaf; nil for a fixed one without, and where there are faults. *)
let behaviour behaviours (l : Bodies.leaf) =
  match l.behaviour with
  | None -> Behaviour.nil
  | Some (env, b) ->
    let owner = { Behaviours.name = l.name; shape = l.shape } in
    Option.value ~default:Behaviour.nil (Behaviours.term behaviours env owner b)

let behaviours_of table (bodies : Bodies.t) keep =
  Array.to_list bodies.leaves
  |> List.mapi (fun i leaf -> (i, leaf))
  |> List.filter (fun (i, _) -> keep i)
  |> List.map (fun (_, leaf) -> Option.fold ~none:Behaviour.nil ~some:(behaviour table) leaf)

(* Which names are used depends on the formulas, too. *)
let warn_unused (c : Context.t) (program : Program.t) =
  let warn what name at =
    if not (Empty.mentions program.empty (Family.bare name)) then
      Report.warning c.report Code.unused at "the %s `%s` is not used" what name
  in
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

let speak_of_time = List.exists (fun (k : Property.check) -> Formula.mentions_time k.formula)
let is_steered (l : Model.leaf) = not (l.fixed || Law.is_inertial l.law)

let warn_of_uses c program =
  Templates.warn_off_centre c;
  warn_unused c program

(* What has a value in itself, in the words of the language. *)
let values (program : Program.t) =
  let shown (_, _, (b : Env.binding)) =
    let text =
      match b.value with
      | Number q -> Some (Rat.to_string q)
      | Truth t -> Some (string_of_bool t)
      | Vector v -> Some (Vec.to_string v)
      | Affine f -> Some (Form.to_string f)
      | Open _ | Word _ | Macro _ | Leaf _ | Unknown -> None
    in
    Option.map (fun text -> (b.span, text)) text
  in
  List.filter_map shown program.values

(* Everything is in order. *)
let build (c : Context.t) bodies (composition : Composition.t) joints initial written later =
  let program = later.program and checks, premises = later.own in
  let definitions = Behaviour.canonical_definitions written in
  let initial = Array.map (Behaviour.canonical written) initial in
  let leaves = Assembly.leaves bodies composition in
  let rigid = Settings.rigid program.settings c.report ~spinning:(Assembly.spinning bodies composition) leaves in
  let steered = Array.exists is_steered leaves in
  let by_law = Array.exists (fun (l : Model.leaf) -> Law.mentions_time l.law) leaves in
  let model =
    {
      Model.leaves;
      definitions;
      timestep = program.timestep;
      splits = program.splits;
      ranges = program.ranges;
      keeps_time = by_law || speak_of_time checks;
      steered;
      steps = program.steps;
      collisions = Settings.collisions program.settings;
      blocked = Settings.blocked program.settings;
      binding = Settings.binding program.settings;
      bonds = Settings.bonds program.settings;
      round_velocity = Settings.round_velocity program.settings;
      lots = false;
      rigid;
    }
  in
  let declared = Assembly.state bodies composition joints initial model in
  let model = { model with lots = Parameters.has_lots model declared } in
  let ended = Context.copy c in
  warn_of_uses c program;
  {
    name = program.name;
    parameters = program.parameters;
    templates = templates c program;
    families = program.families;
    model;
    declared;
    uncertain = Assembly.uncertain bodies composition program.ranges;
    parameter = Asked.parameter (Overrides.asked program.overrides);
    checks;
    premises;
    lattices = composition.lattices;
    warnings = Report.warnings c.report;
    values = values program;
    kept = { later with ended };
  }

(* What nothing uses has been read by nobody. Those that use others come first. *)
let check_unused_lets formulas (program : Program.t) =
  List.iter
    (fun (_, _, (b : Env.binding)) ->
       match b.value with
       | Macro (e, env) when not b.used -> Formulas.check_let formulas env e
       | Macro _ | Number _ | Truth _ | Vector _ | Affine _ | Open _ | Word _ | Leaf _ | Unknown -> ())
    (List.rev program.values)

(* The checks, with what they rest on. *)
let checks_of (c : Context.t) formulas written =
  let checks = List.filter_map (Formulas.check formulas) written in
  (checks, if Report.failed c.report then [] else List.concat_map (Formulas.premises formulas) written)

let read c (program : Program.t) ~whole =
  let bodies = Bodies.read c program in
  let composition = Composition.read c program bodies in
  let table = Behaviours.create c program in
  let included i = composition.included.(i) in
  let initial = Array.of_list (behaviours_of table bodies included) in
  let joints = Joints.read c program bodies composition in
  List.iter (fun (j : Joints.t) -> Behaviours.use_channel table j.name) joints;
  List.iter (Behaviours.use_channel table) (Empty.channels program.empty);
  Behaviours.settle table;
  let formulas = Formulas.create c bodies composition table in
  let own = checks_of c formulas program.checks in
  let subjects = Formulas.copy formulas (Context.copy c) in
  Behaviours.seal table;
  check_unused_lets formulas program;
  ignore (behaviours_of table bodies (fun i -> not (included i)));
  Templates.read_unused c;
  let definitions = Behaviours.finish table in
  Assembly.check_overlaps c bodies composition;
  if not (Report.failed c.report) then
    Settings.check program.settings c.report ~spins:(Option.is_some (Assembly.spinning bodies composition));
  if Report.failed c.report then None
  else
    let later = { program; subjects; ended = c; own; added = []; whole } in
    Some (build c bodies composition joints initial definitions later)

let rec elaborate ~read_file ~overrides ?(narrowed = []) ?parametric syntax =
  let c = Context.create ~read_file in
  Limits.check_depth c.report syntax;
  let program = if Report.failed c.report then None else Program.read c ~overrides ~narrowed ?parametric syntax in
  let whole items = elaborate ~read_file ~overrides ~narrowed ?parametric (List.append syntax items) in
  let result = Option.bind program (read c ~whole) in
  match result with
  | Some t -> Ok t
  | None -> Error (Report.errors c.report)

(* {1 Formulas that are read later} *)

(* What is marked as used meanwhile is not, afterwards. *)
let marking_nothing (program : Program.t) f =
  let values = List.filter (fun (_, _, (b : Env.binding)) -> not b.used) program.values in
  let behaviours = Hashtbl.fold (fun _ (b : Program.behaviour) all -> if b.used then all else b :: all) in
  let behaviours = behaviours program.behaviours [] in
  let finally () =
    List.iter (fun (_, _, (b : Env.binding)) -> b.used <- false) values;
    List.iter (fun (b : Program.behaviour) -> b.used <- false) behaviours
  in
  Fun.protect ~finally f

let with_time (t : t) =
  let { State.processes; step; _ } = t.declared in
  let declared = State.make ~processes:(Array.to_list processes) ~step ~time:(Some Rat.zero) in
  { t with model = { t.model with keeps_time = true }; declared }

let in_kept t items =
  let { program; subjects; ended; own; _ } = t.kept in
  let c = Context.copy subjects.c and ended = Context.copy ended in
  let subjects = Formulas.copy subjects c in
  let known = Behaviours.count subjects.behaviours in
  let written (i : Scc_syntax.Ast.item) =
    match i.it with
    | Check (name, formula) -> Program.check_after program name formula
    | _ -> Bug.fail __POS__ "no check"
  in
  Limits.check_depth c.report items;
  let checks, premises =
    if Report.failed c.report then ([], []) else checks_of c subjects (List.map written items)
  in
  check_unused_lets subjects program;
  if Behaviours.count subjects.behaviours > known then None
  else if Report.failed c.report then Some (Error (Report.errors c.report))
  else begin
    Context.mark_used ended ~by:c;
    warn_of_uses ended program;
    let t = if speak_of_time checks && not t.model.keeps_time then with_time t else t in
    let checks = List.append (fst own) checks and premises = List.append (snd own) premises in
    Some (Ok { t with checks; premises; warnings = Report.warnings ended.report })
  end

let with_checks t items =
  let added = List.append t.kept.added items in
  match marking_nothing t.kept.program (fun () -> in_kept t added) with
  | Some result -> Result.map (fun more -> { more with kept = { t.kept with added } }) result
  | None -> t.kept.whole added
