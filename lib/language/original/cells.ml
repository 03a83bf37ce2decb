open Scc_base
open Scc_exact
open Scc_geometry
open Scc_syntax

(* [polyhedron] is in the frame of the whole. *)
type piece = { name : string; cut : Pieces.piece; polyhedron : Polyhedron.t }
type t = { solid : Extent.solid; whole : Polyhedron.t; pieces : piece array; one : bool }

let max_pieces = 256

(* The normal with its first component that is not zero made 1: planes are equal iff these are. *)
let normal_form (p : Pieces.plane) : Pieces.plane =
  let first = List.find (fun q -> Rat.sign q <> 0) [ p.normal.x; p.normal.y; p.normal.z ] in
  let factor = Rat.div Rat.one first in
  { normal = Vec.scale factor p.normal; offset = Rat.mul factor p.offset }

let compare_planes (p : Pieces.plane) (q : Pieces.plane) =
  match Vec.compare p.normal q.normal with 0 -> Rat.compare p.offset q.offset | c -> c

let face_name (whole : Polyhedron.t) = function
  | Pieces.Face f -> fst whole.faces.(f)
  | Seam k -> Printf.sprintf "seam'%d" (k + 1)

let checked ifs =
  match Polyhedron.of_ifs ifs with
  | Ok p -> p
  | Error _ -> Bug.fail __POS__ "a piece of a convex solid that is none"

let too_many at =
  Fault.refuse Code.too_many_pieces at "the regions of this shape cut it into more than %d pieces" max_pieces
    ~hint:"regions with fewer sides, or with sides in common lines, need fewer cuts"

let make solid whole ~at regions =
  let piece_of i cut =
    let vertex k = Printf.sprintf "v%d" (k + 1) in
    let ifs = Pieces.ifs cut ~vertex ~face:(face_name whole) in
    { name = Printf.sprintf "p%d" (i + 1); cut; polyhedron = checked ifs }
  in
  let uncut = Pieces.whole (Polyhedron.to_ifs whole) in
  let planes =
    List.concat_map (fun (_, r) -> Extent.planes solid r) regions
    |> List.map normal_form
    |> List.filter (fun p -> Pieces.is_cut p uncut)
    |> List.sort_uniq compare_planes
  in
  (* Each plane makes a piece more at least. *)
  if List.compare_length_with planes max_pieces >= 0 then too_many at
  else
    match Pieces.cut ~most:max_pieces planes uncut with
    | None -> too_many at
    | Some [ cut ] -> { solid; whole; pieces = [| { name = ""; cut; polyhedron = whole } |]; one = true }
    | Some pieces -> { solid; whole; pieces = Array.of_list (List.mapi piece_of pieces); one = false }

let is_cut t = not t.one

(* {1 Features} *)

let corners (p : Polyhedron.t) (f : Feature.t) =
  match f with
  | Vertex v -> [ v ]
  | Edge e ->
    let v, w = p.edges.(e) in
    [ v; w ]
  | Face f -> Array.to_list (snd p.faces.(f))

(* A point inside of it. *)
let middle (p : Polyhedron.t) f =
  let places = List.map (fun v -> snd p.vertices.(v)) (corners p f) in
  Vec.scale (Rat.div Rat.one (Rat.of_int (List.length places))) (List.fold_left Vec.add Vec.zero places)

let features (p : Polyhedron.t) =
  List.init (Array.length p.faces) (fun f -> Feature.Face f)
  @ List.init (Array.length p.edges) (fun e -> Feature.Edge e)
  @ List.init (Array.length p.vertices) (fun v -> Feature.Vertex v)

let written t piece span f : Ast.feature =
  let p = piece.polyhedron in
  let prefix = if t.one then [] else [ piece.name ] in
  let path name = Tree.path span (prefix @ [ name ]) in
  match (f : Feature.t) with
  | Face i -> Tree.at span (Ast.Named (path (fst p.faces.(i))))
  | Vertex v -> Tree.at span (Ast.Named (path (fst p.vertices.(v))))
  | Edge _ ->
    let vertex v = Tree.path span [ fst p.vertices.(v) ] in
    let prefix = match prefix with [] -> None | names -> Some (Tree.path span names) in
    Tree.at span (Ast.Tuple (prefix, List.map vertex (corners p f)))

module Features = Hashtbl.Make (Feature)

let of_piece t span region piece =
  let p = piece.polyhedron in
  let inside = Features.create 64 in
  let all = features p in
  List.iter
    (fun f ->
       let x = middle p f in
       if (t.one || Extent.on_surface t.solid x) && Extent.contains t.solid region x then Features.replace
           inside f ())
    all;
  let covered = Features.create 64 in
  let member f =
    if (not (Features.mem inside f)) || Features.mem covered f then None
    else
      let closure = Polyhedron.closure p [ f ] in
      let closed = List.for_all (Features.mem inside) closure in
      if closed then List.iter (fun g -> Features.replace covered g ()) closure;
      Some { Ast.feature = written t piece span f; only = not closed }
  in
  List.filter_map member all

let members t span region = List.concat_map (of_piece t span region) (Array.to_list t.pieces)

(* {1 The compound} *)

let fractions t =
  let volumes = List.map (fun p -> Pieces.volume p.cut) (Array.to_list t.pieces) in
  let whole = List.fold_left Rat.add Rat.zero volumes in
  List.map (fun v -> Rat.div v whole) volumes

let reference span name arguments : Ast.reference =
  { qualifier = None; target = Tree.at span name; indices = []; arguments }

let shape_name (name : Ast.name) piece = Printf.sprintf "%s'%s" name.it piece.name

let centre piece = (Mass_properties.of_polyhedron piece.polyhedron).centroid

(* About its own centroid. *)
let shape (name : Ast.name) piece =
  let at = name.at in
  let centre = centre piece in
  let p = piece.polyhedron in
  let named n = Tree.at at n in
  let vertices = Array.to_list (Array.map (fun (n, v) -> (named n, Tree.vector at (Vec.sub v centre)))
                                  p.vertices) in
  let corner v = named (fst p.vertices.(v)) in
  let face (n, c) = (named n, List.map corner (Array.to_list c)) in
  let faces = List.map face (Array.to_list p.faces) in
  let head = { Ast.declared = named (shape_name name piece); places = []; formals = [] } in
  Tree.at at (Ast.Shape (head, Tree.at at (Ast.Faces (vertices, faces)), []))

let mass_name = "mass_of_all"

let part (name : Ast.name) piece fraction =
  let at = name.at in
  let mass = Tree.at at (Ast.Path (Tree.path at [ mass_name ])) in
  let place = Tree.vector at (centre piece) in
  let share = Tree.at at (Ast.Binary (Mul, Tree.number at fraction, mass)) in
  {
    Ast.part = Tree.at at piece.name;
    part_solid = Tree.at at (Ast.Template (reference at (shape_name name piece) []));
    part_attributes = [ Tree.at at (Ast.Mass share); Tree.at at (Ast.At [ Tree.at at (Ast.Translate place) ]) ];
    part_span = at;
  }

let glue t (name : Ast.name) (i, j, seam) =
  let feature k =
    let path = Tree.path name.at [ t.pieces.(k).name; face_name t.whole (Seam seam) ] in
    Tree.at name.at (Ast.Named path)
  in
  { Ast.glue_first = feature i; glue_second = feature j; glue_span = name.at }

let items t (name : Ast.name) =
  let pieces = Array.to_list t.pieces in
  let head = { Ast.declared = name; places = []; formals = [ Tree.at name.at mass_name ] } in
  let parts = List.map2 (part name) pieces (fractions t) in
  let glues = List.map (glue t name) (Pieces.joints (Array.map (fun p -> p.cut) t.pieces)) in
  List.map (shape name) pieces @ [ Tree.at name.at (Ast.Compound (head, parts, glues, [])) ]
