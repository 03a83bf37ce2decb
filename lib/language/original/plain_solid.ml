open Scc_base
open Scc_exact
open Scc_geometry
open Scc_syntax

type t = { polyhedron : Polyhedron.t; round : Extent.round }
type shapes = { plain : Plain.t; setting : Setting.t; shape : string -> Ast.solid option }

let unknown at =
  Fault.refuse Code.unknown_points at
    "the regions of this shape have to be cut out of it, and its points are not told in plain numbers"
    ~hint:"write it with numbers and constants (`let`); a parameter may have another value in each run"

let vector s e = match Plain.vector s.plain e with Ok v -> v | Error at -> Extent.not_plain at
let number s e = match Plain.number s.plain e with Ok q -> q | Error at -> Extent.not_plain at

let polyhedron at ifs =
  if Polyhedron.too_fine ifs then unknown at
  else
    match Polyhedron.of_ifs ifs with
    | Ok p -> p
    | Error _ ->
      Fault.refuse Code.unknown_points at
        "the regions of this shape have to be cut out of it, and it is no convex solid"
        ~hint:"without those regions, the check of the shape tells what is wrong"

let flat at ifs = { polyhedron = polyhedron at ifs; round = Flat }

let faces s at vertices faces =
  let index = Hashtbl.create 16 in
  List.iteri (fun i ((n : Ast.name), _) -> Hashtbl.replace index n.it i) vertices;
  let corner (n : Ast.name) = match Hashtbl.find_opt index n.it with Some i -> i | None -> unknown n.at in
  flat at
    {
      ifs_vertices = Array.of_list (List.map (fun ((n : Ast.name), v) -> (n.it, vector s v)) vertices);
      ifs_faces =
        Array.of_list
          (List.map (fun ((n : Ast.name), c) -> (n.it, Array.of_list (List.map corner c))) faces);
    }

let is_length q = Rat.sign q > 0

let corners s e =
  let q = number s e in
  if Rat.is_integer q && Rat.compare q (Rat.of_int 3) >= 0 && Rat.compare q (Rat.of_int 256) <= 0 then
    Z.to_int (Rat.floor q)
  else unknown e.at

let named s at (r : Ast.reference) =
  let length e =
    let q = number s e in
    if is_length q then q else unknown e.at
  in
  match (r.target.it, r.arguments) with
  | "box", [ a; b; c ] -> Some (flat at (Named_solids.box (length a) (length b) (length c)))
  | "box", [ e ] ->
    let v = vector s e in
    if List.for_all is_length [ v.x; v.y; v.z ] then Some (flat at (Named_solids.box v.x v.y v.z)) else
      unknown e.at
  | "prism", [ n; r; h ] -> Some (flat at (Named_solids.prism (corners s n) (length r) (length h)))
  | "antiprism", [ n; r; h ] -> Some (flat at (Named_solids.antiprism (corners s n) (length r) (length h)))
  | "pyramid", [ n; r; h ] -> Some (flat at (Named_solids.pyramid (corners s n) (length r) (length h)))
  | _ -> None

let scaled at (v : Vec.t) t =
  if List.exists (fun q -> Rat.sign q <= 0) [ v.x; v.y; v.z ] then unknown at
  else
    let even = Rat.equal v.x v.y && Rat.equal v.y v.z in
    { polyhedron = Polyhedron.transform (Mat.diagonal v) t.polyhedron; round = (if even then t.round else Flat) }

let curved s at (c : Setting.curved) =
  let length e =
    let q = number s e in
    if is_length q then q else unknown e.Ast.at
  in
  match c with
  | Sphere (c, r) ->
    let q = Setting.radius c (length r) in
    { (scaled at (Vec.make q q q) (flat at (Scc_mesh.Curved.ball c.corners))) with round = Ball }
  | Cylinder (c, r, h) ->
    let ifs = Named_solids.prism c.corners (Setting.radius c (length r)) (length h) in
    { (flat at ifs) with round = About_axis }
  | Cone (c, r, h) ->
    let ifs = Named_solids.pyramid c.corners (Setting.radius c (length r)) (length h) in
    { (flat at ifs) with round = About_axis }

let rec solid s depth (x : Ast.solid) =
  if depth > 100 then Fault.refuse Code.too_deep x.at "shapes are more than 100 within one another";
  match x.it with
  | Faces (vertices, fs) -> faces s x.at vertices fs
  | Hull points -> (
      match Scc_mesh.Hull_of.named (List.map (fun ((n : Ast.name), v) -> (n.it, vector s v)) points) with
      | Some ifs -> flat x.at ifs
      | None -> unknown x.at)
  | Scaled (y, v) -> scaled x.at (vector s v) (solid s (depth + 1) y)
  | Mesh _ -> unknown x.at
  | Template ({ qualifier = None; indices = []; _ } as r) -> (
      match (s.shape r.target.it, r.arguments) with
      | Some y, [] -> solid s (depth + 1) y
      | Some _, _ :: _ -> unknown x.at
      | None, _ -> (
          match Setting.curved s.setting r with
          | Some c -> curved s x.at c
          | None -> ( match named s x.at r with Some t -> t | None -> unknown x.at)))
  | Template _ -> unknown x.at

let of_solid s x = solid s 0 x
