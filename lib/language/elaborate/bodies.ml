open Scc_base
open Scc_exact
open Scc_syntax
open Scc_calculus

type leaf = {
  name : string;
  process : int;
  shape : Shape.t;
  parts : Model.part array;
  mass : Rat.t;
  fixed : bool;
  absorbs : bool;
  place : Form.place;
  position : Vec.t;
  velocity : Vec.t;
  spin : Vec.t;
  behaviour : (Env.t * Ast.behaviour) option;
  span : Span.t;
}

type process = {
  name : string;
  labelled : bool;
  members : int list;
  bonds : (Env.t * Ast.bond) list;
}

type t = { leaves : leaf option array; processes : process array; registry : Registry.t }

(* The mass of a fixed body has no meaning; one stands for it. *)
let check_fixed report (a : Attributes.t) =
  let refuse what = function
    | None -> ()
    | Some at ->
      Report.error report Code.fixed_motion at "a fixed body has no %s: it never moves" what
        ~hint:"leave it out, or declare a `process`"
  in
  refuse "mass" (Option.map snd a.mass);
  refuse "velocity" (Option.map snd a.velocity);
  refuse "spin" (Option.map snd a.spin)

let basic_mass report name (at : Span.t) (a : Attributes.t) =
  match a.mass with
  | Some (m, _) -> Some m
  | None ->
    Report.error report Code.bad_value at "the process `%s` has no mass" name
      ~hint:"write `mass m` with m > 0, or declare it `fixed`";
    None

let check_compound_mass report (compound : Shape.compound) (a : Attributes.t) =
  Option.iter
    (fun (_, at) ->
       Report.error report Code.repeated_attribute at "the parts of `%s` have their masses already"
         compound.clabel)
    a.mass

let basic_parts (c : Context.t) ~fixed name at (a : Attributes.t) (b : Shape.basic) =
  let*? mass = if fixed then Some Rat.one else basic_mass c.report name at a in
  let solid = c.solid b a.at.linear in
  Some [| { Model.name; template = b.label; solid; offset = Vec.zero; open_offset = None; mass } |]

(* What hits an absorbing body is gone, and so it does nothing itself (rule Absorb). *)
let check_absorbing report ~fixed name (a : Attributes.t) (l : Ast.leaf) =
  match a.absorb with
  | None -> ()
  | Some at ->
    if not fixed then
      Report.error report Code.bad_absorber at "`%s` moves, and only what is fixed can absorb" name
        ~hint:(Printf.sprintf "declare it as `fixed %s = …`" name)
    else
      Option.iter
        (fun (b : Ast.behaviour) ->
           Report.error report Code.bad_absorber b.at "`%s` absorbs what hits it, and has no behaviour" name
             ~hint:"leave the brackets out")
        l.behaviour

(* T o T_part for each part; the reference point of the leaf is where T takes the origin. *)
let compound_parts (c : Context.t) name (a : Attributes.t) (compound : Shape.compound) =
  let n = Array.length c.point in
  let over_ranges form =
    let x, y, z = Form.turned a.at.linear form in
    if Option.is_some (Form.fixed (x, y, z)) then None
    else Some (Form.linear n x, Form.linear n y, Form.linear n z)
  in
  let place (p : Shape.part) =
    let placement = Affine.compose (Affine.of_linear a.at.linear) p.placement in
    {
      Model.name = name ^ "." ^ p.name;
      template = p.basic.label;
      solid = c.solid p.basic placement.linear;
      offset = placement.translation;
      open_offset = over_ranges p.place;
      mass = p.mass;
    }
  in
  Array.map place compound.parts

let check_fixed_compound report at (compound : Shape.compound) =
  let refuse what v =
    if not (Vec.is_zero v) then
      Report.error report Code.fixed_motion at "the parts of `%s` have a %s, and a fixed body never moves"
        compound.clabel what
  in
  refuse "velocity" compound.velocity;
  refuse "spin" compound.spin

let parts (c : Context.t) ~fixed name at (a : Attributes.t) shape =
  if fixed then check_fixed c.report a;
  match (shape : Shape.t) with
  | Basic b -> basic_parts c ~fixed name at a b
  | Compound compound ->
    if fixed then check_fixed_compound c.report at compound
    else check_compound_mass c.report compound a;
    Some (compound_parts c name a compound)

(* What the body gives, else what the parts of its compound do, in the world. *)
let own_motion ~fixed (a : Attributes.t) (shape : Shape.t) =
  let velocity, spin =
    match shape with
    | Compound compound -> (compound.velocity, compound.spin)
    | Basic _ -> (Vec.zero, Vec.zero)
  in
  let given attribute default = Option.fold ~none:default ~some:fst attribute in
  if fixed then (Vec.zero, Vec.zero) else (given a.velocity velocity, given a.spin spin)

let leaf (c : Context.t) (body : Program.body) ~process ~name (at : Span.t) (l : Ast.leaf) =
  let shape = Templates.shape c body.env ~label:name l.solid in
  let a = Attributes.read c.report body.env l.attributes in
  check_absorbing c.report ~fixed:body.fixed name a l;
  let*? shape = shape in
  let*? parts = parts c ~fixed:body.fixed name at a shape in
  if not a.complete then None
  else
    let velocity, spin = own_motion ~fixed:body.fixed a shape in
    Some
      {
        name;
        process;
        shape;
        parts;
        mass = Array.fold_left (fun sum (p : Model.part) -> Rat.add sum p.mass) Rat.zero parts;
        fixed = body.fixed;
        absorbs = Option.is_some a.absorb;
        place = a.at.translation;
        position = Form.at c.point a.at.translation;
        velocity;
        spin;
        behaviour = Option.map (fun b -> (body.env, b)) l.behaviour;
        span = at;
      }

let centroid (l : leaf) =
  let shape : Model.leaf =
    {
      name = l.name; template = ""; parts = l.parts; fixed = l.fixed; absorbs = l.absorbs; mass = l.mass;
      law = Inertial; law_at = Span.none;
    }
  in
  Vec.add l.position (Model.leaf_centroid shape)

(* What is read so far; numbers are given in the order of declaration. *)
type reading = {
  c : Context.t;
  names : Registry.t;
  mutable found : leaf option list;
  mutable count : int;
  mutable groups : process list;
  mutable group_count : int;
}

let read_leaf r (body : Program.body) (segment : Ast.segment) (l : Ast.leaf) =
  let*? name = Constant.segment r.c.report body.env segment in
  let number = r.count in
  Registry.add r.names segment name (Registry.Leaf number);
  r.found <- leaf r.c body ~process:r.group_count ~name segment.name.at l :: r.found;
  r.count <- number + 1;
  Some number

let read_body r (body : Program.body) =
  let*? name = Constant.segment r.c.report body.env body.name in
  let labelled = Option.is_some body.first.label in
  let label (l : Ast.leaf) = Option.value ~default:body.name l.label in
  let read l = read_leaf r body (label l) l in
  let members = List.filter_map read (body.first :: List.map snd body.rest) in
  if labelled then Registry.add r.names body.name name (Registry.Process members);
  let bonds = List.map (fun (bond, _) -> (body.env, bond)) body.rest in
  r.groups <- { name; labelled; members; bonds } :: r.groups;
  r.group_count <- r.group_count + 1;
  Some ()

let read (c : Context.t) (program : Program.t) =
  let names = Registry.create c.report in
  let r = { c; names; found = []; count = 0; groups = []; group_count = 0 } in
  List.iter (fun b -> ignore (read_body r b)) program.bodies;
  List.iter (Registry.declare_family names) program.families.bodies;
  {
    leaves = Array.of_list (List.rev r.found);
    processes = Array.of_list (List.rev r.groups);
    registry = names;
  }
