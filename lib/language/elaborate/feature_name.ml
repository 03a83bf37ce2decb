open Scc_base
open Scc_geometry
open Scc_syntax
open Scc_calculus

type t = { prefix : (string * Span.t) list; what : what; span : Span.t; env : Env.t }
and what = Name of string * Span.t | Cycle of (string * Span.t) list

let segment_span (s : Ast.segment) =
  match List.rev s.indices with
  | [] -> s.name.at
  | last :: _ -> Span.merge s.name.at last.at

let is_unknown env (s : Ast.segment) =
  match (s.indices, Env.find env s.name.it) with
  | [], Some Unknown -> true
  | _ -> false

let segments report env (path : Ast.path) =
  let add whole s =
    match (whole, Constant.segment report env s) with
    | Some _, Some _ when is_unknown env s -> None
    | Some whole, Some name ->
      let name = match s.indices with [] -> Family.word env name | _ :: _ -> name in
      Some ((name, segment_span s) :: whole)
    | _ -> None
  in
  Option.map List.rev (List.fold_left add (Some []) path.it)

let split_last names =
  match List.rev names with
  | [] -> Bug.fail __POS__ "an empty path"
  | last :: before -> (List.rev before, last)

let same_names = List.equal (fun (a, _) (b, _) -> String.equal a b)

(* The vertices of a tuple and the prefix that they share. *)
let vertices report env (paths : Ast.path list) =
  let*? all = Option.all (fun path -> Option.map split_last (segments report env path)) paths in
  match all with
  | [] -> Some ([], [])
  | (prefix, _) :: _ ->
    let stray = List.find_opt (fun (p, _) -> not (same_names p prefix)) all in
    (match stray with
     | None -> Some (prefix, List.map snd all)
     | Some (_, (name, at)) ->
       Report.error report Code.unknown_feature at
         "the vertex `%s` is of another shape than the first of the tuple"
         name;
       None)

let read report env (f : Ast.feature) =
  match f.it with
  | Named path ->
    let*? names = segments report env path in
    let prefix, (name, at) = split_last names in
    Some { prefix; what = Name (name, at); span = f.at; env }
  | Tuple (prefix, paths) ->
    let*? outer = Option.fold ~none:(Some []) ~some:(segments report env) prefix in
    let*? inner, cycle = vertices report env paths in
    Some { prefix = outer @ inner; what = Cycle cycle; span = f.at; env }

let feature_names (p : Polyhedron.t) =
  Array.to_list (Array.map fst p.faces) @ Array.to_list (Array.map fst p.vertices)

let unknown report label p at name =
  let { Polyhedron.ifs_vertices; ifs_faces } = Polyhedron.to_ifs p in
  let told = Printf.sprintf "its faces are %s; its vertices %s" in
  Report.error report Code.unknown_feature at "`%s` has no feature `%s`" label name
    ~near:(name, fun () -> feature_names p)
    ~notes:[ (Span.none, told (Solid_report.names ifs_faces) (Solid_report.names ifs_vertices)) ];
  None

let vertex report label (p : Polyhedron.t) (name, at) =
  match Polyhedron.find_vertex p name with
  | Some v -> Some v
  | None -> unknown report label p at name

let cycle report label (p : Polyhedron.t) span corners =
  let found = List.map (vertex report label p) corners in
  let names = String.concat "," (List.map fst corners) in
  if not (List.for_all Option.is_some found) then None
  else
    match List.filter_map Fun.id found with
    | [] ->
      Report.error report Code.unknown_feature span "an empty tuple names no feature";
      None
    | [ v ] -> Some (Feature.Vertex v)
    | [ v; w ] -> (
        match Polyhedron.find_edge p v w with
        | Some e -> Some (Feature.Edge e)
        | None ->
          Report.error report Code.unknown_feature span "[%s] is not an edge of `%s`" names label;
          None)
    | corners -> (
        let corners = Array.of_list corners in
        let n = Array.length corners in
        let reversed = Array.init n (fun i -> corners.(n - 1 - i)) in
        match (Polyhedron.find_cycle p corners, Polyhedron.find_cycle p reversed) with
        | Some f, _ -> Some (Feature.Face f)
        | None, Some f ->
          Report.error report Code.unknown_feature span
            "[%s] is the face `%s` of `%s` the wrong way round" names
            (fst p.faces.(f))
            label ~hint:"list its corners counter-clockwise as seen from outside";
          None
        | None, None ->
          Report.error report Code.unknown_feature span "[%s] is not a face of `%s`" names label;
          None)

let on_polyhedron report label (p : Polyhedron.t) f =
  match f.what with
  | Cycle corners -> cycle report label p f.span corners
  | Name (name, at) -> (
      match (Polyhedron.find_face p name, Polyhedron.find_vertex p name) with
      | Some face, _ -> Some (Feature.Face face)
      | None, Some v -> Some (Feature.Vertex v)
      | None, None -> unknown report label p at name)

let not_a_part report (c : Shape.compound) (name, at) =
  Report.error report Code.unknown_feature at "`%s` has no part `%s`" c.clabel name
    ~near:(name, fun () -> Array.to_list (Array.map (fun (p : Shape.part) -> p.name) c.parts));
  None

let bare report (c : Shape.compound) f =
  let hint = Printf.sprintf "say of which part, as in `%s.top`" c.parts.(0).name in
  Report.error report Code.bare_feature f.span "a feature of the compound `%s` needs the name of its part"
    c.clabel ~hint;
  None

(* {1 On a shape} *)

type meaning = { listed : Site.t list; inside : Site.t list; closed : Site.t list }

let part_closure (p : Polyhedron.t) part features =
  List.map (fun feature -> { Site.part; feature }) (Polyhedron.closure p features)

let of_part p (site : Site.t) =
  { listed = [ site ]; inside = [ site ]; closed = part_closure p site.part [ site.feature ] }

let one meaning = match meaning.listed with [ site ] -> Some site | _ -> None

(* {2 Of a drawn solid} *)

let same_part part (s : Site.t) = Int.equal s.part part

(* The closures that features have in their own parts. *)
let closures polyhedra sites =
  let parts = List.sort_uniq Int.compare (List.map (fun (s : Site.t) -> s.part) sites) in
  let of_part part =
    part_closure polyhedra.(part) part
      (List.map (fun (s : Site.t) -> s.feature) (List.filter (same_part part) sites))
  in
  List.concat_map of_part parts

(* Those that are in the closure of no other one. *)
let largest polyhedra sites =
  let dimension (s : Site.t) = Feature.dimension s.feature in
  let larger = List.sort (fun a b -> Int.compare (dimension b) (dimension a)) sites in
  let keep (kept, covered) site =
    if List.exists (Site.equal site) covered then (kept, covered)
    else (site :: kept, closures polyhedra [ site ] @ covered)
  in
  List.sort Site.compare (fst (List.fold_left keep ([], []) larger))

let of_drawn shape (d : Scc_concave.Parts.t) feature =
  let sites list = List.map (fun (part, feature) -> { Site.part; feature }) list in
  let closed = sites (Scc_concave.Parts.closed d feature) in
  { listed = largest (Shape.polyhedra shape) closed; inside = sites (Scc_concave.Parts.inside d feature); closed }

let unknown_drawn report label (d : Scc_concave.Parts.t) at name =
  let set = d.drawn.set in
  let told = Printf.sprintf "its faces are %s; its vertices %s" in
  let all () = Array.to_list (Array.map fst set.ifs_faces) @ Array.to_list (Array.map fst set.ifs_vertices) in
  Report.error report Code.unknown_feature at "`%s` has no feature `%s`" label name ~near:(name, all)
    ~notes:[ (Span.none, told (Solid_report.names set.ifs_faces) (Solid_report.names set.ifs_vertices)) ];
  None

let found_drawn report (c : Shape.compound) d at text found =
  match (found : Scc_concave.Parts.found) with
  | Shown feature -> Some (of_drawn (Shape.Compound c) d feature)
  | Flat ->
    Report.error report Code.flat_feature at
      "%s is no feature of `%s`: it is inside a face, or an edge that goes straight on" text c.clabel
      ~hint:"faces that are side by side in one plane are one face: name that";
    None
  | Turned face ->
    Report.error report Code.unknown_feature at "%s is the face `%s` of `%s` the wrong way round" text face
      c.clabel
      ~hint:"list its corners counter-clockwise as seen from outside";
    None
  | Nothing ->
    Report.error report Code.unknown_feature at "%s is no feature of `%s`" text c.clabel;
    None

let on_drawn report (c : Shape.compound) (d : Scc_concave.Parts.t) f =
  match f.what with
  | Name (name, at) -> (
      match Scc_concave.Parts.face_or_vertex d name with
      | Nothing -> unknown_drawn report c.clabel d at name
      | found -> found_drawn report c d at (Printf.sprintf "`%s`" name) found)
  | Cycle corners ->
    let vertex (name, at) =
      match Scc_concave.Parts.vertex d name with
      | Some v -> Some v
      | None -> unknown_drawn report c.clabel d at name
    in
    let found = List.map vertex corners in
    let text = Printf.sprintf "[%s]" (String.concat "," (List.map fst corners)) in
    if List.for_all Option.is_some found then
      found_drawn report c d f.span text (Scc_concave.Parts.tuple d (List.filter_map Fun.id found))
    else None

(* {2 Of all shapes} *)

let on_compound report (c : Shape.compound) f =
  let resolve (name, at) =
    match Shape.part_index c name with
    | None -> not_a_part report c (name, at)
    | Some part ->
      let label = Printf.sprintf "%s.%s" c.clabel name in
      let polyhedron = c.parts.(part).basic.polyhedron in
      on_polyhedron report label polyhedron f
      |> Option.map (fun feature -> of_part polyhedron { Site.part; feature })
  in
  match (f.prefix, c.drawn) with
  | [], None -> bare report c f
  | [], Some drawn -> on_drawn report c drawn f
  | [ part ], _ -> resolve part
  | _ :: (_, at) :: _, _ ->
    Report.error report Code.unknown_feature at "the parts of `%s` have no parts" c.clabel;
    None

(* The name of the leaf itself may come first. A compound's part may have that name as well; a drawn one has
   features without a part. *)
let strip_own ~own shape prefix =
  match (own, prefix, shape) with
  | Some own, (first, _) :: rest, Shape.Basic _ when String.equal own first -> rest
  | Some own, (first, _) :: (_ :: _ as rest), Shape.Compound _ when String.equal own first -> rest
  | Some own, [ (first, _) ], Shape.Compound ({ drawn = Some _; _ } as c)
    when String.equal own first && Option.is_none (Shape.part_index c first) -> []
  | _ -> prefix

(* With the name that the text has for it, for messages. *)
let as_written env : Shape.t -> Shape.t = function
  | Basic b -> Basic { b with label = Env.said env b.label }
  | Compound c -> Compound { c with clabel = Env.said env c.clabel }

let on_shape report ~own shape f =
  let shape = as_written f.env shape in
  let prefix = strip_own ~own shape f.prefix in
  match (shape, prefix) with
  | Shape.Basic b, [] ->
    on_polyhedron report b.label b.polyhedron f
    |> Option.map (fun feature -> of_part b.polyhedron { Site.part = 0; feature })
  | Shape.Basic b, (name, at) :: _ ->
    Report.error report Code.unknown_feature at "`%s` is a basic shape and has no part `%s`" b.label name
      ~hint:"a feature of a basic shape is named alone, or after the name of its own process";
    None
  | Shape.Compound c, _ -> on_compound report c { f with prefix }

let closed_by_parts shape meaning =
  let sorted = List.sort_uniq Site.compare in
  List.equal Site.equal (sorted (closures (Shape.polyhedra shape) meaning.listed)) (sorted meaning.closed)
