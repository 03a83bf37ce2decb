open Scc_base
open Scc_exact
open Scc_geometry
open Scc_syntax

let names (model : Ast.model) =
  List.filter_map
    (fun (item : Ast.item) ->
       match item.it with Shape (head, _, _) -> Some (Printer.head head) | _ -> None)
    model

let all options = if List.for_all Option.is_some options then Some (List.filter_map Fun.id options) else None

let listed report env vertices faces =
  let index = Hashtbl.create 16 in
  List.iteri (fun i ((n : Ast.name), _) -> Hashtbl.replace index n.it i) vertices;
  let corner (n : Ast.name) =
    match Hashtbl.find_opt index n.it with
    | Some i -> Some i
    | None ->
      Report.error report Code.unknown_feature n.at "the shape has no vertex `%s`" n.it;
      None
  in
  let place ((n : Ast.name), v) = Option.map (fun p -> (n.it, p)) (Constant.corner report env v) in
  let face ((n : Ast.name), corners) =
    Option.map (fun c -> (n.it, Array.of_list c)) (all (List.map corner corners))
  in
  let*? vertices = all (List.map place vertices) in
  let*? faces = all (List.map face faces) in
  Some { Polyhedron.ifs_vertices = Array.of_list vertices; ifs_faces = Array.of_list faces }

let scaled (set : Polyhedron.ifs) (f : Vec.t) =
  let scale (name, (v : Vec.t)) =
    (name, Vec.make (Rat.mul f.x v.x) (Rat.mul f.y v.y) (Rat.mul f.z v.z))
  in
  { set with ifs_vertices = Array.map scale set.ifs_vertices }

let hull report env at points =
  let place ((n : Ast.name), v) = Option.map (fun p -> (n.it, p)) (Constant.corner report env v) in
  let*? points = all (List.map place points) in
  Solids.hull report at points

(* References from shape to shape, as those of {!Templates}. *)
let max_nesting = 100

let rec set (c : Context.t) report depth env (solid : Ast.solid) =
  match solid.it with
  | Faces (vertices, faces) -> listed report env vertices faces
  | Hull points -> hull report env solid.at points
  | Mesh (path, snap) -> Mesh_file.read report env ~read_file:c.read_file path snap
  | Scaled (inner, factors) ->
    let*? set = set c report depth env inner in
    let*? f = Constant.scaling report env solid.at factors in
    Some (scaled set f)
  | Template r -> named c report depth env r

and named c report depth env (r : Ast.reference) =
  let*? reference = Family.reference report env r in
  let is_compound () =
    Report.error report Code.wrong_kind r.target.at "`%s` is a compound, and a single shape is needed here"
      (Env.said env reference.label) ~hint:"its parts are the shapes to look at";
    None
  in
  match Family.find c.sources reference with
  | Some _ when depth > max_nesting ->
    Report.error report Code.too_deep r.target.at "more than %d instances of shapes are needed for one another"
      max_nesting;
    None
  | Some source ->
    let env = Family.bind source.scope source.source_head.formals reference.arguments in
    set c report (depth + 1) (Family.define report env source.definitions) source.written
  | None when Option.is_some (Family.find c.families reference) -> is_compound ()
  | None -> (
      match Solids.find report r reference with
      | Some ifs -> ifs
      | None when Hashtbl.mem c.templates reference.label -> is_compound ()
      | None ->
        Family.report_unknown report env "template" (Family.keys c.sources) ~predefined:Solids.names r reference;
        None)

(* A name as on the command line: [Cube], [m.Cube], [Brick(1, 2, 3)]. *)
let reference asked_at name =
  let at (n : Ast.name) = { n with at = asked_at } in
  match Scc_syntax.Parse.parse (Source.make ~name:"the command line" ("fixed it = " ^ name)) with
  | Ok [ { it = Fixed (_, { solid = { it = Template r; _ }; _ }, []); _ } ] ->
    { r with target = at r.target; qualifier = Option.map at r.qualifier }
  | Ok _ | Error _ ->
    { Ast.qualifier = None; target = { Ast.it = name; at = asked_at }; indices = []; arguments = [] }

(* What else is wrong with the model is not looked at. *)
let find ~read_file ~overrides ~asked_at model name =
  let c = Context.create ~read_file in
  let report = Report.create () in
  Limits.check_depth report model;
  if Report.failed report then Error (Report.errors report)
  else begin
    Option.iter
      (fun (p : Program.t) -> Overrides.check p.overrides report asked_at)
      (Program.read c ~overrides ~narrowed:[] model);
    match named c report 0 c.root (reference asked_at name) with
    | Some set when not (Report.failed report) -> Ok (set, Report.warnings report)
    | _ -> Error (Report.errors report)
  end
