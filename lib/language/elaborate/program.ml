open Scc_base
open Scc_exact
open Scc_syntax
open Scc_calculus

type body = {
  env : Env.t;
  name : Ast.segment;
  first : Ast.leaf;
  rest : (Ast.bond * Ast.leaf) list;
  fixed : bool;
}

type behaviour = {
  env : Env.t;
  name : Ast.name;
  label : string;
  formals : Ast.name list;
  definitions : Ast.definitions;
  on : Ast.reference option;
  body : Ast.behaviour;
  mutable used : bool;
}

type check = { env : Env.t; name : string; span : Span.t; formula : Ast.expr; written : Ast.expr -> string }
type motion = { env : Env.t; target : Ast.path option; law : Ast.law; at : Span.t }

type t = {
  name : string option;
  overrides : Overrides.t;
  parameters : (string * Rat.t) list;
  ranges : Ranges.t;
  shapes : string list;
  timestep : Rat.t;
  steps : Model.steps;
  splits : Model.splits;
  settings : Settings.t;
  families : Repeated.t;
  empty : Empty.t;
  bodies : body list;
  bonds : (Env.t * Ast.bond) list;
  behaviours : (string, behaviour) Hashtbl.t;
  network : (Env.t * Ast.path list * Span.t) option;
  motions : motion list;
  checks : check list;
  values : (string * string * Env.binding) list;
  last : Env.t;
}

(* What is gathered on the way, lists in reverse. *)
type gathered = {
  c : Context.t;
  overrides : Overrides.t;
  declared : (string, Span.t) Hashtbl.t;  (* parameters and lets at the top *)
  check_names : (string, Span.t) Hashtbl.t;
  behaviour_table : (string, behaviour) Hashtbl.t;
  mutable model : Ast.name option;
  mutable params : (string * Rat.t) list;
  mutable ranges : Ranges.range list;
  mutable templates : string list;
  mutable delta : (Rat.t option * Span.t) option;
  mutable steps : Model.steps;
  mutable split : (Model.splits option * Span.t) option;
  settings : Settings.t;
  mutable all_bodies : body list;
  mutable all_bonds : (Env.t * Ast.bond) list;
  mutable composition : (Env.t * Ast.path list * Span.t) option;
  mutable all_motions : motion list;
  mutable all_checks : check list;
  mutable all_values : (string * string * Env.binding) list;
  modules : Modules.t;
  reached : (int, unit) Hashtbl.t;  (* where loops begin that have made a declaration *)
  mutable expanded : int;
  mutable overflow : bool;
}

(* Where an item stands: the values of the loops about it, the innermost first, and what names their variables
   and lets have. *)
type place = { env : Env.t; loops : Z.t list; names : string list }

let at_top env = { env; loops = []; names = [] }

let in_loop place =
  match place.loops with
  | [] -> false
  | _ :: _ -> true

let repeated g at what first =
  Report.error g.c.report Code.repeated_attribute at "%s is given twice" what
    ~notes:[ (first, "the first is here") ]

let once_named table report (name : Ast.name) what =
  match Hashtbl.find_opt table name.it with
  | Some first ->
    Report.error report Code.duplicate_name name.at "the %s `%s` is declared twice" what name.it
      ~notes:[ (first, "the first is here") ]
  | None -> Hashtbl.add table name.it name.at

let bind g place what (name : Ast.name) value =
  let binding = { Env.value; span = name.at; used = false } in
  if Env.is_own place.env then g.all_values <- (what, name.it, binding) :: g.all_values;
  if not (in_loop place) then Hashtbl.replace (Env.scope_of place.env).top name.it binding;
  { place with env = Env.add name.it binding place.env }

let param g place (name : Ast.name) e =
  let global = Env.own place.env name.it in
  once_named g.declared g.c.report { name with it = global } "value";
  let written = Constant.number g.c.report place.env e in
  let also = Modules.called g.modules (Env.scope_of place.env) name.it in
  let value =
    match Overrides.value g.overrides g.c.report ~name:global ~also with
    | Some q -> Some q
    | None -> written
  in
  (* after an error the rest is read with a harmless value *)
  let q = Option.value ~default:Rat.one value in
  g.params <- (global, q) :: g.params;
  bind g place "parameter" name (Env.Number q)

let end_ g place (l : Ast.limit) =
  Constant.number ~why:"the ends of a range must be known" g.c.report place.env l.value
  |> Option.map (fun value -> { Ranges.value; included = l.included })

(* What the parameter is: known after all, or in a range that has a number. *)
let param_in g place (name : Ast.name) (low : Ast.limit) (high : Ast.limit) =
  let global = Env.own place.env name.it in
  once_named g.declared g.c.report { name with it = global } "value";
  let also = Modules.called g.modules (Env.scope_of place.env) name.it in
  let given = Overrides.given g.overrides g.c.report ~name:global ~also in
  let at = Span.make ~file:name.at.file ~start:low.value.at.start ~stop:high.value.at.stop in
  let range =
    let*? low, high = Typed.both (end_ g place low) (end_ g place high) in
    Restricted.range g.c.report at { Ranges.name = global; low; high } given
  in
  match range with
  | Some (Known q) ->
    g.params <- (global, q) :: g.params;
    bind g place "parameter" name (Env.Number q)
  | Some (In range) when Asked.is (Overrides.asked g.overrides) ~name:global ~also ->
    bind g place "parameter" name (Env.Open (Asked.found (Overrides.asked g.overrides) range))
  | Some (In range) ->
    let index = List.length g.ranges in
    g.ranges <- range :: g.ranges;
    g.c.point <- Ranges.point (Array.of_list (List.rev g.ranges));
    bind g place "parameter" name (Env.Affine (Form.variable { index; name = global }))
  | None -> bind g place "parameter" name (Env.Number Rat.one)

let let_ g place (name : Ast.name) e =
  if not (in_loop place) then
    once_named g.declared g.c.report { name with it = Env.own place.env name.it } "value";
  let value =
    if Constant.is_constant place.env e then
      Option.value ~default:(Env.Number Rat.one) (Constant.value g.c.report place.env e)
    else Env.Macro (e, place.env)
  in
  let place = bind g place "`let`" name value in
  if in_loop place then { place with names = name.it :: place.names } else place

let check_at place (name : Ast.name) formula =
  let printed =
    match place.loops with
    | [] -> name.it
    | loops -> Printf.sprintf "%s[%s]" name.it (String.concat "," (List.rev_map Z.to_string loops))
  in
  let written e = Scc_syntax.Printer.expr (Written.expr place.env place.names e) in
  { env = place.env; name = printed; span = name.at; formula; written }

let check g place name formula =
  let check = check_at place name formula in
  once_named g.check_names g.c.report { name with it = check.name } "check";
  g.all_checks <- check :: g.all_checks

let check_after t name formula = check_at (at_top t.last) name formula

let enter_behaviour g place (name : Ast.name) (head : Family.head) definitions on body =
  Hashtbl.replace (Env.scope_of place.env).declared name.it ();
  match Hashtbl.find_opt g.behaviour_table head.key with
  | Some first ->
    Report.error g.c.report Code.duplicate_name name.at "the behaviour `%s` is declared twice"
      (Env.said place.env head.key)
      ~notes:[ (first.name.at, "the first is here") ]
  | None ->
    let { Family.key; formals } = head in
    Hashtbl.add g.behaviour_table key
      { env = place.env; name; label = key; formals; definitions; on; body; used = false }

let declare_behaviour g place (head : Ast.head) definitions on body =
  Option.iter
    (fun known -> enter_behaviour g place head.declared known definitions on body)
    (Family.head g.c.report place.env head)

let given_once g earlier what (e : Ast.expr) read =
  match earlier with
  | Some (_, first) ->
    repeated g e.at (Printf.sprintf "`%s`" what) first;
    earlier
  | None -> Some (read e, e.at)

let step g place earlier what e = given_once g earlier what e (Constant.positive g.c.report place.env what)

(* [any], unless that is the name of a value. *)
let splits g place (e : Ast.expr) =
  match e.it with
  | Path { it = [ { name = { it = "any"; _ }; indices = [] } ]; _ } when not (Env.mem place.env "any") ->
    Some Model.Any_time
  | _ -> Option.map (fun q -> Model.Every q) (Constant.positive g.c.report place.env "split_step" e)

let body g place fixed name first rest =
  g.all_bodies <- { env = place.env; name; first; rest; fixed } :: g.all_bodies

(* Declarations that have no index to tell their copies apart do not stand in a loop. *)
let allowed_in_loop (item : Ast.item) =
  match item.it with
  | Process _ | Fixed _ | Bond _ | For _ | Motion _ | Let _ | Check _ | Behaviour _ -> true
  | Model _ | Import _ | Param _ | Param_in _ | Timestep _ | Split_step _ | Dynamics _ | Collisions _ | Binding _
  | Bonds _ | Blocked _ | Resolution _ | Round _ | Shape _ | Compound _ | Decomposed _
  | Network _ -> false

let declared = "what is declared must be known"

let range g place (r : Ast.range) =
  match
    ( Constant.integer ~why:declared g.c.report place.env "the bound of a loop" r.bounds.low,
      Constant.integer ~why:declared g.c.report place.env "the bound of a loop" r.bounds.high )
  with
  | Some a, Some b -> Some (a, b)
  | _ -> None

let too_many g at =
  if not g.overflow then begin
    g.overflow <- true;
    Report.error g.c.report Code.too_deep at "the loops of the model make more than %d declarations"
      Limits.items
  end

let rec item g place (i : Ast.item) =
  g.expanded <- g.expanded + 1;
  match i.it with
  | _ when not (Env.is_own place.env || Modules.may_hold i) ->
    Report.error g.c.report Code.wrong_kind i.at "this declaration cannot be imported"
      ~hint:"a module declares parameters, lets, shapes, compounds and behaviours; bodies, laws, checks \
             and settings are the model's";
    place
  | Import import when not (in_loop place) -> { place with env = imported g place import }
  | _ when in_loop place && not (allowed_in_loop i) ->
    Report.error g.c.report Code.wrong_kind i.at "this declaration cannot stand in a `for`"
      ~hint:"only processes, fixed bodies, bonds, motions, lets, checks and behaviours can";
    place
  | Param (name, e) -> param g place name e
  | Param_in (name, low, high) -> param_in g place name low high
  | Let (name, e) -> let_ g place name e
  | For (ranges, items) ->
    loop g place i.at ranges items;
    place
  | _ ->
    simple g place i;
    place

and imported g place import =
  let read scope items =
    ignore (List.fold_left (item g) (at_top (Env.root scope)) items)
  in
  Modules.import g.modules g.c.report ~read_file:g.c.read_file ~read place.env import

and simple g place (i : Ast.item) =
  match i.it with
  | Model name ->
    Option.iter (fun (first : Ast.name) -> repeated g name.at "the name of the model" first.at) g.model;
    g.model <- Some name
  | Timestep (e, kind) ->
    g.delta <- step g place g.delta "timestep" e;
    g.steps <- (match kind with Shared -> Shared | Local -> Own | Steady -> Steady)
  | Split_step e -> g.split <- given_once g g.split "split_step" e (splits g place)
  | Dynamics name -> Settings.dynamics g.settings g.c.report name
  | Collisions name -> Settings.read_collisions g.settings g.c.report name
  | Binding name -> Settings.read_binding g.settings g.c.report name
  | Bonds name -> Settings.read_bonds g.settings g.c.report name
  | Blocked name -> Settings.read_blocked g.settings g.c.report name
  | Resolution e -> Settings.resolution g.settings g.c.report place.env e
  | Round (what, e) -> Settings.round g.settings g.c.report place.env what e
  | Shape (head, solid, definitions) ->
    g.templates <- Env.own place.env head.declared.it :: g.templates;
    Templates.declare_shape g.c place.env head solid definitions
  | Compound (head, parts, glues, definitions) ->
    g.templates <- Env.own place.env head.declared.it :: g.templates;
    Compounds.declare g.c place.env head parts glues definitions
  | Decomposed (head, solid, attributes, definitions) ->
    g.templates <- Env.own place.env head.declared.it :: g.templates;
    Decomposition.declare g.c place.env head solid attributes definitions
  | Behaviour (head, on, b, definitions) -> declare_behaviour g place head definitions on b
  | Process (name, first, rest) -> body g place false name first rest
  | Fixed (name, first, rest) -> body g place true name first rest
  | Bond b -> g.all_bonds <- (place.env, b) :: g.all_bonds
  | Network paths ->
    Option.iter (fun (_, _, first) -> repeated g i.at "`network`" first) g.composition;
    g.composition <- Some (place.env, paths, i.at)
  | Motion (target, law) ->
    g.all_motions <- { env = place.env; target; law; at = i.at } :: g.all_motions
  | Check (name, e) -> check g place name e
  | Import _ | Param _ | Param_in _ | Let _ | For _ -> Bug.fail __POS__ "a declaration that changes the scope"

(* The ranges of one [for] nest, the first outermost. *)
and loop g place at ranges items =
  match ranges with
  | [] ->
    Hashtbl.replace g.reached at.Span.start ();
    ignore (List.fold_left (item g) place items)
  | first :: rest -> (
      match range g place first with
      | None -> ()
      | Some (low, high) ->
        if Z.compare (Z.sub high low) (Z.of_int Limits.items) > 0 then too_many g at
        else iterate g place at first low high rest items)

and iterate g place at (r : Ast.range) i high rest items =
  if Z.compare i high > 0 then ()
  else if g.overflow || g.expanded >= Limits.items then too_many g at
  else begin
    g.expanded <- g.expanded + 1;
    let binding = { Env.value = Number (Rat.make i Z.one); span = r.index.at; used = false } in
    let inner =
      {
        env = Env.add r.index.it binding place.env;
        loops = i :: place.loops;
        names = r.index.it :: place.names;
      }
    in
    let admitted =
      match r.bounds.filter with
      | None -> Some true
      | Some c -> Constant.truth ~why:declared g.c.report inner.env c
    in
    if Option.value ~default:false admitted then loop g inner at rest items;
    if Option.is_some admitted then iterate g place at r (Z.succ i) high rest items
  end

let gather c overrides narrowed parametric =
  {
    c;
    overrides = Overrides.create ~narrowed ?parametric overrides;
    declared = Hashtbl.create 16;
    check_names = Hashtbl.create 16;
    behaviour_table = Hashtbl.create 16;
    model = None;
    params = [];
    ranges = [];
    templates = [];
    delta = None;
    steps = Shared;
    split = None;
    settings = Settings.create ();
    all_bodies = [];
    all_bonds = [];
    composition = None;
    all_motions = [];
    all_checks = [];
    all_values = [];
    modules = Modules.create ();
    reached = Hashtbl.create 16;
    expanded = 0;
    overflow = false;
  }

let program g model ~last =
  let value step ~default = match step with Some (Some q, _) -> q | Some (None, _) | None -> default in
  let timestep = value g.delta ~default:Rat.one in
  {
    name = Option.map (fun (n : Ast.name) -> n.it) g.model;
    overrides = g.overrides;
    parameters = List.rev g.params;
    ranges = Array.of_list (List.rev g.ranges);
    shapes = List.rev g.templates;
    timestep;
    steps = g.steps;
    splits = value g.split ~default:(Model.Every timestep);
    settings = g.settings;
    families = Repeated.of_model model;
    empty = Empty.make model ~reached:(Hashtbl.mem g.reached);
    bodies = List.rev g.all_bodies;
    bonds = List.rev g.all_bonds;
    behaviours = g.behaviour_table;
    network = g.composition;
    motions = List.rev g.all_motions;
    checks = List.rev g.all_checks;
    values = List.rev g.all_values;
    last;
  }

(* As the model's folder knows it. *)
let file_of (model : Ast.model) =
  match model with [] -> "" | i :: _ -> Filename.basename i.at.file

let read c ~overrides ~narrowed ?parametric model =
  let g = gather c overrides narrowed parametric in
  c.root <- Env.root (Env.scope ~prefix:"" ~file:(file_of model) ());
  Modules.start g.modules (Env.scope_of c.root) model;
  let after = List.fold_left (item g) (at_top c.root) model in
  Overrides.check g.overrides c.report Span.none;
  if List.length model = 0 then Report.error c.report Code.empty_model Span.none "the model declares nothing";
  if g.overflow then None else Some (program g model ~last:after.env)
