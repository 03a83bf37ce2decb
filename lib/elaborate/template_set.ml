open Scc_base
open Scc_exact
open Scc_geometry
open Scc_syntax

let ( let* ) = Option.bind

let environment report overrides (model : Ast.model) =
  let add env (item : Ast.item) =
    let bind (name : Ast.name) value =
      Env.add name.it { Env.value; span = name.at; used = false } env
    in
    match item.it with
    | Param (name, e) -> (
        match List.assoc_opt name.it overrides with
        | Some q -> bind name (Env.Number q)
        | None -> (
            match Constant.number report env e with
            | Some q -> bind name (Env.Number q)
            | None -> env))
    | Let (name, e) when Constant.is_constant env e -> (
        match Constant.value report env e with Some v -> bind name v | None -> env)
    | _ -> env
  in
  List.fold_left add Env.empty model

let templates (model : Ast.model) =
  List.filter_map
    (fun (item : Ast.item) ->
       match item.it with Shape (name, solid) -> Some (name.it, solid) | _ -> None)
    model

let is_compound (model : Ast.model) name =
  List.exists
    (fun (item : Ast.item) ->
       match item.it with Compound (n, _, _) -> String.equal n.it name | _ -> false)
    model

let names model = List.map fst (templates model)
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
  let place ((n : Ast.name), v) = Option.map (fun p -> (n.it, p)) (Constant.vector report env v) in
  let face ((n : Ast.name), corners) =
    Option.map (fun c -> (n.it, Array.of_list c)) (all (List.map corner corners))
  in
  let* vertices = all (List.map place vertices) in
  let* faces = all (List.map face faces) in
  Some { Polyhedron.ifs_vertices = Array.of_list vertices; ifs_faces = Array.of_list faces }

let scaled (set : Polyhedron.ifs) (f : Vec.t) =
  let scale (name, (v : Vec.t)) =
    (name, Vec.make (Rat.mul f.x v.x) (Rat.mul f.y v.y) (Rat.mul f.z v.z))
  in
  { set with ifs_vertices = Array.map scale set.ifs_vertices }

(* A template may only name those before it, so what is left to look at shrinks. *)
let rec before name = function
  | [] -> None
  | (n, solid) :: earlier -> if String.equal n name then Some (solid, earlier) else before name earlier

let rec set report read_file env earlier (solid : Ast.solid) =
  match solid.it with
  | Faces (vertices, faces) -> listed report env vertices faces
  | Mesh (path, snap) -> Mesh_file.read report env ~read_file path snap
  | Scaled (inner, factors) ->
    let* set = set report read_file env earlier inner in
    let* f = Constant.scaling report env solid.at factors in
    Some (scaled set f)
  | Template name -> named report read_file env earlier name.it name.at

and named report read_file env earlier name at =
  match before name earlier with
  | Some (solid, earlier) -> set report read_file env earlier solid
  | None ->
    Report.error report Code.unknown_name at "unknown template `%s`" name
      ~near:(name, fun () -> List.map fst earlier);
    None

(* Values for parameters that there are not. *)
let check_overrides report overrides (model : Ast.model) at =
  let parameter (item : Ast.item) = match item.it with Param (name, _) -> Some name.it | _ -> None in
  let names = List.filter_map parameter model in
  let check (name, _) =
    if not (List.exists (String.equal name) names) then
      Report.error report Code.unknown_parameter at "the model has no parameter `%s`" name
        ~near:(name, fun () -> names)
  in
  List.iter check overrides

let find ~read_file ~overrides ~asked_at model name =
  let report = Report.create () in
  Limits.check_depth report model;
  check_overrides report overrides model asked_at;
  if is_compound model name then
    Report.error report Code.wrong_kind asked_at "`%s` is a compound, and a single shape is needed here" name
      ~hint:"its parts are the shapes to look at";
  if Report.failed report then Error (Report.errors report)
  else
    let env = environment report overrides model in
    match named report read_file env (List.rev (templates model)) name asked_at with
    | Some set when not (Report.failed report) -> Ok set
    | _ -> Error (Report.errors report)
