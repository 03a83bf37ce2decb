open Scc_base
open Scc_syntax

type kind =
  | Model
  | Parameter
  | Value
  | Index
  | Variable
  | Argument
  | Shape
  | Compound
  | Part
  | Vertex
  | Face
  | Behaviour
  | Process
  | Fixed
  | Leaf
  | Check
  | Module
  | Imported

type t = {
  kind : kind;
  name : Ast.name;
  what : string;
  shown : Span.t option;
  inner : t list;
  by_name : (string, t) Hashtbl.t Lazy.t;
  solid : Ast.solid option;
  source : (Ast.import * string) option;
}

let kind = function
  | Model -> "model"
  | Parameter -> "parameter"
  | Value -> "value"
  | Index -> "index"
  | Variable -> "variable"
  | Argument -> "argument"
  | Shape -> "shape"
  | Compound -> "compound"
  | Part -> "part"
  | Vertex -> "vertex"
  | Face -> "face"
  | Behaviour -> "behaviour"
  | Process -> "process"
  | Fixed -> "fixed"
  | Leaf -> "leaf"
  | Check -> "check"
  | Module -> "module"
  | Imported -> "imported"

let by_name inner =
  let table = Hashtbl.create (List.length inner) in
  List.iter (fun d -> Hashtbl.add table d.name.it d) inner;
  table

let make ?shown ?(inner = []) ?solid kind name what =
  { kind; name; what; shown; inner; by_name = lazy (by_name inner); solid; source = None }

let text fmt = Printf.sprintf fmt
let count list one several = match List.length list with 1 -> "1 " ^ one | n -> text "%d %s" n several

(* {1 Solids in words} *)

let arguments = function [] -> "" | es -> text "(%s)" (String.concat ", " (List.map Printer.expr es))

let reference (r : Ast.reference) =
  Option.fold ~none:"" ~some:(fun (q : Ast.name) -> q.it ^ ".") r.qualifier ^ r.target.it ^ arguments r.arguments

let rec solid (s : Ast.solid) =
  match s.it with
  | Template r -> reference r
  | Scaled (s, v) -> text "%s scaled %s" (solid s) (Printer.expr v)
  | Mesh (file, _) -> text "mesh \"%s\"" file.it
  | Faces (vertices, faces) ->
    text "%s and %s" (count vertices "vertex" "vertices") (count faces "face" "faces")
  | Hull points -> text "the hull of %s" (count points "point" "points")

let attribute (a : Ast.attribute) =
  match a.it with
  | Mass e -> [ "mass " ^ Printer.expr e ]
  | Velocity e -> [ "velocity " ^ Printer.expr e ]
  | Spin e -> [ "spin " ^ Printer.expr e ]
  | Absorb -> [ "it absorbs what hits it" ]
  | At _ -> []

(* What is printed is ASCII. *)
let short s = if String.length s <= 60 then s else String.sub s 0 60 ^ " …"

let body (s : Ast.solid) attributes behaviour =
  let behaves (b : Ast.behaviour) =
    match b.it with Nil -> [] | _ -> [ "behaves as " ^ short (Printer.behaviour b) ]
  in
  let behaviour = Option.fold ~none:[] ~some:behaves behaviour in
  String.concat ", " ((solid s :: List.concat_map attribute attributes) @ behaviour)

(* {1 Features} *)

let features owner (s : Ast.solid) =
  let vertex ((n : Ast.name), (v : Ast.vector)) =
    make Vertex n (text "vertex `%s` of `%s`, at %s" n.it owner (Printer.expr v))
  in
  let face ((n : Ast.name), (corners : Ast.name list)) =
    let corners = String.concat ", " (List.map (fun (c : Ast.name) -> c.it) corners) in
    make Face n (text "face `%s` of `%s`, with the corners %s" n.it owner corners)
  in
  match s.it with
  | Faces (vertices, faces) -> List.append (List.map vertex vertices) (List.map face faces)
  | Hull points -> List.map vertex points
  | Template _ | Scaled _ | Mesh _ -> []

let part owner (p : Ast.part) =
  make Part p.part ~shown:p.part_span ~solid:p.part_solid
    (text "part `%s` of `%s`: %s" p.part.it owner (body p.part_solid p.part_attributes None))

(* {1 Items} *)

let module_name (i : Ast.import) =
  if i.library then i.from
  else { i.from with it = Filename.remove_extension (Filename.basename i.from.it) }

let from (i : Ast.import) = if i.library then text "<%s>" i.from.it else text "\"%s\"" i.from.it

let of_import (i : Ast.import) shown =
  let alias = match i.names with Qualified alias -> alias | Chosen _ -> None in
  let name = Option.value alias ~default:(module_name i) in
  let what = if i.library then "the library's module " ^ from i else "the module of the file " ^ from i in
  { (make Module name ~shown what) with source = Some (i, "") }

let import (i : Ast.import) shown =
  match i.names with
  | Qualified _ -> [ of_import i shown ]
  | Chosen names ->
    let one ((n : Ast.name), alias) =
      let name = Option.value alias ~default:n in
      { (make Imported name ~shown (text "`%s` of %s" n.it (from i))) with source = Some (i, n.it) }
    in
    List.map one names

let leaf owner (l : Ast.leaf) =
  let what = body l.solid l.attributes l.behaviour in
  let one (s : Ast.segment) =
    make Leaf s.name ~shown:l.leaf_span ~solid:l.solid
      (text "body `%s` of the process `%s`: %s" s.name.it owner what)
  in
  Option.map one l.label

let bodies kind word shown (s : Ast.segment) (first : Ast.leaf) rest =
  let leaves = first :: List.map snd rest in
  let path = { s.name with it = [ s ] } in
  let called = Printer.expr { s.name with it = Ast.Path path } in
  let labelled = List.filter_map (leaf called) leaves in
  let what, solid =
    match rest with
    | [] -> (body first.solid first.attributes first.behaviour, Some first.solid)
    | _ :: _ -> (text "%d bodies that are bound" (List.length leaves), None)
  in
  make kind s.name ~shown ~inner:labelled ?solid (text "%s `%s`: %s" word called what) :: labelled

let behaviour (head : Ast.head) (on : Ast.reference option) =
  let for_what = Option.fold ~none:"" ~some:(fun r -> text ", for `%s`" (reference r)) on in
  let family = match (head.places, head.formals) with [], [] -> "behaviour" | _ -> "family of behaviours" in
  text "%s `%s`%s" family (Printer.head head) for_what

let limits (low : Ast.limit) (high : Ast.limit) =
  text "%s%s, %s%s"
    (if low.included then "[" else "(")
    (Printer.expr low.value) (Printer.expr high.value)
    (if high.included then "]" else ")")

let item (i : Ast.item) =
  let shown = i.at in
  match i.it with
  | Model n -> [ make Model n ~shown (text "the model is called `%s`" n.it) ]
  | Import import' -> import import' shown
  | Param (n, e) ->
    [ make Parameter n ~shown (text "parameter `%s`, %s if nothing else is given" n.it (Printer.expr e)) ]
  | Param_in (n, low, high) ->
    [ make Parameter n ~shown (text "parameter `%s`, any number in %s" n.it (limits low high)) ]
  | Let (n, _) -> [ make Value n ~shown (text "value `%s`" n.it) ]
  | Check (n, _) -> [ make Check n ~shown (text "check `%s`" n.it) ]
  | Shape (head, s, _) ->
    let name = head.declared in
    let what = text "shape `%s`: %s" (Printer.head head) (solid s) in
    [ make Shape name ~shown ~inner:(features name.it s) ~solid:s what ]
  | Compound (head, parts, glues, _) ->
    let name = head.declared in
    let made_of = count parts "part" "parts" ^ ", " ^ count glues "glue" "glues" in
    let what = text "compound `%s`: %s" (Printer.head head) made_of in
    [ make Compound name ~shown ~inner:(List.map (part name.it) parts) what ]
  | Decomposed (head, s, attributes, _) ->
    let name = head.declared in
    let what = text "compound `%s`: %s in convex parts" (Printer.head head) (body s attributes None) in
    [ make Compound name ~shown ~inner:(features name.it s) what ]
  | Behaviour (head, on, _, _) -> [ make Behaviour head.declared ~shown (behaviour head on) ]
  | Process (s, first, rest) -> bodies Process "process" shown s first rest
  | Fixed (s, first, rest) -> bodies Fixed "fixed body" shown s first rest
  | Timestep _ | Split_step _ | Dynamics _ | Collisions _ | Binding _ | Bonds _ | Blocked _ | Resolution _ | Round _
  | Bond _ | For _ | Network _ | Motion _ -> []

(* {1 Tables} *)

type table = (string, t) Hashtbl.t

type all = {
  items : (int, t) Hashtbl.t;
  bodies : table;
  behaviours : table;
  templates : table;
  values : table;
  modules : table;
  features : table;
}

let add table d = Hashtbl.add table d.name.it d

(* The last one that was added comes first. *)
let find table name = List.rev (Hashtbl.find_all table name)
let at all (name : Ast.name) = Hashtbl.find_all all.items name.at.start

let enter all d =
  Hashtbl.add all.items d.name.at.start d;
  (match d.kind with Shape | Compound -> List.iter (add all.features) d.inner | _ -> ());
  match d.kind with
  | Process | Fixed | Leaf -> add all.bodies d
  | Behaviour -> add all.behaviours d
  | Shape | Compound -> add all.templates d
  | Parameter | Value -> add all.values d
  | Module -> add all.modules d
  | Imported -> List.iter (fun table -> add table d) [ all.behaviours; all.templates; all.values ]
  | Model | Check | Index | Variable | Argument | Part | Vertex | Face -> ()

let of_model (model : Ast.model) =
  let table () = Hashtbl.create 16 in
  let all =
    {
      items = Hashtbl.create 64;
      bodies = table ();
      behaviours = table ();
      templates = table ();
      values = table ();
      modules = table ();
      features = table ();
    }
  in
  let rec read (i : Ast.item) =
    match i.it with
    | For (_, items) -> List.iter read items
    | _ -> List.iter (enter all) (item i)
  in
  List.iter read model;
  all
