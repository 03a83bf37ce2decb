open Scc_base
open Scc_exact
open Scc_geometry
open Scc_concave
open Scc_syntax

(* Instances that are made for one another. *)
let max_nesting = 100

(* The spans of the vertices and faces of a solid that the model itself lists. *)
type places = { whole : Span.t; vertices : Span.t array; faces : Span.t array }

(* What a fault points at: the feature at fault and another that matters. *)
type feature = Vertex of int | Face of int

let features : Polyhedron_fault.t -> feature option * feature option = function
  | No_faces | Inward -> (None, None)
  | Flat i | Bad_vertex_index (i, _) | Short_face i | Open_edge (i, _, _) | Turned_face (i, _)
  | Self_crossing (i, _) ->
    (Some (Face i), None)
  | Repeated_edge (i, j, _, _) | Coplanar_neighbours (i, j) | Separate_solids (i, j) ->
    (Some (Face i), Some (Face j))
  | Same_position (i, j) -> (Some (Vertex j), Some (Vertex i))
  | Unused_vertex i -> (Some (Vertex i), None)
  | Off_plane (i, k) | Degenerate_face (i, k) | In_plane (i, k) -> (Some (Face i), Some (Vertex k))
  | Not_convex (i, k) -> (Some (Vertex k), Some (Face i))

(* In a file nobody writes faces by hand: the words that mend a mesh, if they are not there yet. *)
let word_that_mends (m : Ast.mending) : Polyhedron_fault.t -> string option = function
  | Coplanar_neighbours _ when not m.merge ->
    Some "write `merge` after the file: neighbours in one plane become one face"
  | (Same_position _ | Unused_vertex _) when not m.weld ->
    Some "write `weld` after the file: equal points become one vertex"
  | (Turned_face _ | Inward) when not m.orient ->
    Some "write `orient` after the file: faces are turned over so that all look outwards"
  | Not_convex _ -> Some "a compound = decompose \"file\" cuts a solid that is not convex into convex parts"
  | _ -> None

let message (ifs : Polyhedron.ifs) fault =
  let vertex i = fst ifs.ifs_vertices.(i) and face i = fst ifs.ifs_faces.(i) in
  Polyhedron_fault.message ~vertex ~face fault

let report_fault (c : Context.t) ?mending ?cure places (ifs : Polyhedron.ifs) fault =
  let vertex i = fst ifs.ifs_vertices.(i) and face i = fst ifs.ifs_faces.(i) in
  let located = function
    | Vertex i when i < Array.length places.vertices -> Some places.vertices.(i)
    | Face i when i < Array.length places.faces -> Some places.faces.(i)
    | Vertex _ | Face _ -> None
  in
  let named = function
    | Vertex i -> Printf.sprintf "the vertex `%s` is here" (vertex i)
    | Face i -> Printf.sprintf "the face `%s` is here" (face i)
  in
  let first, second = features fault in
  let span = Option.value ~default:places.whole (Option.bind first located) in
  let notes =
    match second with
    | None -> []
    | Some f -> Option.to_list (Option.map (fun at -> (at, named f)) (located f))
  in
  let hint =
    match (cure, Option.bind mending (fun m -> word_that_mends m fault)) with
    | Some cure, _ -> cure
    | None, (Some _ as word) -> word
    | None, None -> Polyhedron_fault.hint ~vertex ~face fault
  in
  Report.error c.report (Polyhedron_fault.code fault) span ~notes ?hint
    "%s" (message ifs fault)

(* What can be done about a whole mesh is said once, as words of a model: with the fault that is told first, since
   of many the last are left out. *)
let report_faults c ?mending ?(decomposed = false) places ifs faults =
  let union ~orient =
    match (decomposed, orient) with
    | true, false -> "write `union` after the file"
    | true, true -> "write `orient` and `union` after the file"
    | false, false -> "a compound = decompose \"file\" union"
    | false, true -> "a compound = decompose \"file\" orient union"
  in
  let cure (m : Ast.mending) =
    match Several_solids.advice ?union:(if m.union then None else Some union) ifs with
    | Some _ as cure -> cure
    | None ->
      let written d = Printf.sprintf "write `grid %s weld` after the file: gaps between faces close" d in
      Option.map (fun d -> written (Decimal.significant ~digits:1 d)) (Mended.closing ifs faults)
  in
  match Option.bind mending cure with
  | None -> List.iter (report_fault c ?mending places ifs) faults
  | Some _ as cure ->
    let place fault = ((Polyhedron_fault.code fault :> string), message ifs fault) in
    let faults = List.sort (fun a b -> compare (place a) (place b)) faults in
    List.iteri (fun i -> report_fault c ~cure:(if i = 0 then cure else None) places ifs) faults

let face_span places i = if i < Array.length places.faces then places.faces.(i) else places.whole

let accept (c : Context.t) ?mending places ~label ifs =
  if Polyhedron.too_fine ifs then begin
    Report.error c.report Code.number_too_large places.whole
      "the common denominator of the coordinates is too large"
      ~hint:"use decimals, or fractions with few different denominators";
    None
  end
  else
    match Polyhedron.of_ifs ifs with
    | Ok polyhedron ->
      let id = c.fresh () in
      Some { Shape.id; root = id; label; polyhedron }
    | Error faults ->
      report_faults c ?mending places ifs faults;
      None

(* Vertices and faces share one space of names, as features do. *)
let check_names (c : Context.t) vertices faces =
  let seen = Hashtbl.create 16 in
  let fresh (n : Ast.name) =
    match Hashtbl.find_opt seen n.it with
    | None ->
      Hashtbl.add seen n.it n.at;
      true
    | Some first ->
      Report.error c.report Code.duplicate_name n.at "`%s` names two features of one shape" n.it
        ~notes:[ (first, "the first is here") ];
      false
  in
  let vertices = List.map (fun (n, _) -> fresh n) vertices in
  let faces = List.map (fun (n, _) -> fresh n) faces in
  List.for_all Fun.id vertices && List.for_all Fun.id faces

(* Sets of faces that are made, and not written. *)
let made (c : Context.t) ~label at ifs = accept c { whole = at; vertices = [||]; faces = [||] } ~label ifs

let hull (c : Context.t) env ~label at points =
  let distinct = check_names c points [] in
  let place ((n : Ast.name), v) = Option.map (fun p -> (n.it, p)) (Constant.corner c.report env v) in
  let places = List.map place points in
  if distinct && List.for_all Option.is_some places then
    Option.bind (Solids.hull c.report at (List.filter_map Fun.id places)) (made c ~label at)
  else None

let taken (c : Context.t) key =
  match (Hashtbl.find_opt c.templates key, Hashtbl.find_opt c.families key) with
  | Some t, _ -> Some t.span
  | None, Some f -> Some f.family_span
  | None, None -> None

let enter (c : Context.t) env (h : Ast.head) (head : Family.head) make =
  let at = h.declared.at in
  Hashtbl.replace (Env.scope_of env).declared h.declared.it ();
  match (taken c head.key, head.formals) with
  | Some first, _ ->
    Report.error c.report Code.duplicate_name at "the template `%s` is declared twice" (Env.said env head.key)
      ~notes:[ (first, "the first is here") ]
  | None, [] ->
    Hashtbl.add c.templates head.key
      { Context.shape = make env head.key; span = at; own = Env.is_own env; declared = true; used = false }
  | None, _ :: _ ->
    let make (r : Family.reference) = make (Family.bind env head.formals r.arguments) r.label in
    Hashtbl.add c.families head.key
      { Context.head; make; family_span = at; family_own = Env.is_own env; instances = 0 }

let declare (c : Context.t) env (h : Ast.head) definitions make =
  let make env label = make (Family.define c.report env definitions) label in
  Option.iter (fun head -> enter c env h head make) (Family.head c.report env h)

let instance (c : Context.t) (f : Context.family) (r : Ast.reference) (reference : Family.reference) =
  if c.nesting >= max_nesting then begin
    Report.error c.report Code.too_deep r.target.at "more than %d instances of shapes are needed for one \
                                                     another: `%s`"
      max_nesting reference.label;
    None
  end
  else begin
    f.instances <- f.instances + 1;
    c.nesting <- c.nesting + 1;
    let shape = f.make reference in
    c.nesting <- c.nesting - 1;
    Hashtbl.replace c.templates reference.label
      { Context.shape; span = f.family_span; own = false; declared = false; used = true };
    shape
  end

let known (c : Context.t) (reference : Family.reference) =
  match Hashtbl.find_opt c.templates reference.label with
  | Some t ->
    t.used <- true;
    Some t.shape
  | None -> None

let predefined (c : Context.t) (r : Ast.reference) (reference : Family.reference) =
  let*? label = Solids.label r reference in
  match Hashtbl.find_opt c.made label with
  | Some shape -> Some shape
  | None ->
    let*? ifs = Solids.find c.report r reference in
    let solid = Option.bind ifs (made c ~label r.target.at) in
    let shape = Option.map (fun b -> Shape.Basic b) solid in
    if not (Family.is_open reference) then Hashtbl.replace c.made label shape;
    Some shape

let find_known (c : Context.t) env (r : Ast.reference) (reference : Family.reference) =
  match (known c reference, Family.find c.families reference) with
  | Some shape, _ -> shape
  | None, Some _ when Family.is_open reference -> None
  | None, Some f -> instance c f r reference
  | None, None -> (
      match predefined c r reference with
      | Some shape -> shape
      | None ->
        let predefined = Solids.names in
        Family.report_unknown c.report env "template" (Context.template_names c) ~predefined r reference;
        None)

let find (c : Context.t) env (r : Ast.reference) =
  let*? reference = Family.reference c.report env r in
  find_known c env r reference

let resolve_corners (c : Context.t) index (face : Ast.name) corners =
  let names () = Hashtbl.fold (fun name _ all -> name :: all) index [] |> List.sort String.compare in
  let resolve (n : Ast.name) =
    match Hashtbl.find_opt index n.it with
    | Some i -> Some i
    | None ->
      Report.error c.report Code.unknown_feature n.at
        "the face `%s` names a vertex `%s` that the shape does not have"
        face.it n.it
        ~near:(n.it, names);
      None
  in
  let found = List.map resolve corners in
  if List.for_all Option.is_some found then Some (Array.of_list (List.filter_map Fun.id found)) else None

let listed_set (c : Context.t) env vertices faces =
  let distinct = check_names c vertices faces in
  let index = Hashtbl.create 16 in
  List.iteri (fun i ((n : Ast.name), _) -> Hashtbl.replace index n.it i) vertices;
  let place ((n : Ast.name), v) = Option.map (fun p -> (n.it, p)) (Constant.corner c.report env v) in
  let corners ((n : Ast.name), vs) = Option.map (fun a -> (n.it, a)) (resolve_corners c index n vs) in
  let places_of = List.map place vertices and faces_of = List.map corners faces in
  if distinct && List.for_all Option.is_some places_of && List.for_all Option.is_some faces_of then
    let array l = Array.of_list (List.filter_map Fun.id l) in
    Some { Polyhedron.ifs_vertices = array places_of; ifs_faces = array faces_of }
  else None

let places_of at vertices faces =
  let spans l = Array.of_list (List.map (fun ((n : Ast.name), _) -> n.at) l) in
  { whole = at; vertices = spans vertices; faces = spans faces }

let listed (c : Context.t) env ~label at vertices faces =
  let*? set = listed_set c env vertices faces in
  accept c (places_of at vertices faces) ~label set

let mesh (c : Context.t) env ~label (path : string Ast.loc) mending =
  let*? ifs = Mesh_file.read c.report env ~read_file:c.read_file path mending in
  accept c ~mending { whole = path.at; vertices = [||]; faces = [||] } ~label ifs

let rec basic (c : Context.t) env ~label (s : Ast.solid) =
  match s.it with
  | Template r -> (
      let*? shape = find c env r in
      match shape with
      | Basic b -> Some b
      | Compound _ ->
        Report.error c.report Code.wrong_kind r.target.at
          "`%s` is a compound, and a single solid is needed here" r.target.it;
        None)
  | Scaled (inner, factors) ->
    let inner = basic c env ~label inner and factors = Constant.scaling c.report env s.at factors in
    let*? b = inner in
    let*? f = factors in
    let polyhedron, id = c.scaled b f in
    Some { b with id; polyhedron }
  | Mesh (path, snap) -> mesh c env ~label path snap
  | Hull points -> hull c env ~label s.at points
  | Faces (vertices, faces) -> listed c env ~label s.at vertices faces

let shape (c : Context.t) env ~label (s : Ast.solid) =
  match s.it with
  | Template r -> find c env r
  | Scaled _ | Mesh _ | Faces _ | Hull _ -> Option.map (fun b -> Shape.Basic b) (basic c env ~label s)

let declare_shape (c : Context.t) env head solid definitions =
  Option.iter
    (fun (known : Family.head) ->
       Hashtbl.replace c.sources known.key { Context.scope = env; source_head = known; written = solid;
                                             definitions })
    (Family.head (Report.create ()) env head);
  declare c env head definitions (fun env label ->
      basic c env ~label solid |> Option.map (fun b -> Shape.Basic { b with Shape.label }))

let read_unused (c : Context.t) =
  let unused _ (f : Context.family) list = if f.instances = 0 then f :: list else list in
  let place (f : Context.family) = (f.family_span.file, f.family_span.start) in
  let in_order a b =
    let (file, start), (file', start') = (place a, place b) in
    String.compare file file' <?> fun () -> Int.compare start start'
  in
  let read (f : Context.family) =
    let { Family.key; formals } = f.head in
    ignore (f.make { label = key; keys = [ key ]; arguments = Family.unknown formals })
  in
  List.iter read (List.sort in_order (Hashtbl.fold unused c.families []))

(* The roots of what is in use: an image of an off-centre shape is off centre through no fault of its own. *)
let warn_off_centre (c : Context.t) =
  let warned = Hashtbl.create 16 in
  let roots (t : Context.template) =
    match t.shape with
    | Some (Basic b) when b.id = b.root -> [ b ]
    | _ -> []
  in
  let warn (t : Context.template) (b : Shape.basic) =
    if not (Hashtbl.mem warned b.root) then begin
      Hashtbl.add warned b.root ();
      let centroid = (c.solid b Mat.identity).Solid.centroid in
      if not (Vec.is_zero centroid) then
        Report.warning c.report Code.off_centre t.span
          "the centroid of `%s` is at %s of its frame, not at the origin" b.label (Vec.in_short centroid)
          ~hint:"nothing depends on it: motion and contact are computed about the true centroid"
    end
  in
  let in_use =
    Hashtbl.fold (fun _ t list -> if t.Context.used && t.own then t :: list else list) c.templates []
  in
  let in_order (a : Context.template) (b : Context.template) = Int.compare a.span.start b.span.start in
  List.iter (fun t -> List.iter (warn t) (roots t)) (List.sort in_order in_use)
