open Scc_exact
open Scc_geometry
open Scc_rigid
open Scc_calculus
open Scc_json
open Scc_runs
open Json_format

(* {1 Solids} *)

let corners = Rows.named "corners" ~text:"Numbers of vertices." (list natural)

let solid_format =
  let feature ?about_corners () =
    fields [ field "name" some_text fst; field "corners" corners snd ?about:about_corners ]
  in
  let vertices (s : Solid.t) = List.init (Array.length s.vertices) (Solid.vertex s) in
  let corner_names (s : Solid.t) = Array.to_list (Array.map fst s.polyhedron.vertices) in
  let edges (s : Solid.t) =
    let edge i (a, b) = (Polyhedron.feature_name s.polyhedron (Edge i), [ a; b ]) in
    List.mapi edge (Array.to_list s.polyhedron.edges)
  in
  let faces (s : Solid.t) =
    List.map (fun (name, corners) -> (name, Array.to_list corners)) (Array.to_list s.polyhedron.faces)
  in
  fields
    [
      field "name" some_text fst ~about:"Of the template.";
      field "vertices" (list Shared.vector) (fun (_, s) -> vertices s)
        ~about:"About the part's point of reference, of the body as it was declared.";
      field "corners" (list some_text) (fun (_, s) -> corner_names s) ~about:"The names of the vertices.";
      field "edges" (list (feature ())) (fun (_, s) -> edges s);
      field "faces"
        (list (feature ~about_corners:"Counter-clockwise, seen from outside." ()))
        (fun (_, s) -> faces s);
    ]
  |> Rows.named "solid" ~text:"A convex polyhedron."

(* {1 Leaves} *)

type t = { leaf : Model.leaf; family : int; parts : (Model.part * int) list; turns : bool }

let inertia (l : Model.leaf) =
  let part (p : Model.part) : Mass.part =
    { body = { solid = p.solid; turned = Quaternion.identity; at = p.offset }; mass = p.mass }
  in
  (Mass.of_parts (List.map part (Array.to_list l.parts))).inertia

let part =
  fields
    [
      field "name" some_text (fun ((p : Model.part), _) -> p.name);
      field "template" some_text (fun ((p : Model.part), _) -> p.template);
      field "solid" Rows.number snd;
      field "offset" Shared.vector (fun ((p : Model.part), _) -> p.offset)
        ~about:"Of the part's point of reference from the leaf's.";
    ]

let format =
  let part_of f b = f b.leaf in
  let mass (l : Model.leaf) : Rat.t option = if l.fixed then None else Some l.mass in
  fields
    [
      field "name" some_text (part_of (fun l -> l.name));
      field "family" Rows.number (fun b -> b.family) ~about:"What looks alike: an index into families.";
      field "template" some_text (part_of (fun l -> l.template));
      field "fixed" bool (part_of (fun l -> l.fixed));
      field "absorbs" bool (part_of (fun l -> l.absorbs));
      field "mass" (nullable Shared.rational) (part_of mass) ~about:"null: fixed.";
      field "parts" (list part) (fun b -> b.parts);
      field "centroid" Shared.vector (part_of Model.leaf_centroid)
        ~about:"Of its shape, from its point of reference, as it was declared.";
      maybe "inertia" Shared.matrix
        (fun b -> if b.turns && not b.leaf.fixed then Some (inertia b.leaf) else None)
        ~about:"About its centroid, as it was declared, where bodies turn.";
    ]
  |> Rows.named "body" ~text:"A leaf, of which states tell where it is."

let leaves ~solids (m : Model.t) =
  let families = Families.of_model m in
  let part (p : Model.part) = (p, Rows.add solids solid_format (p.template, p.solid)) in
  let leaf i (l : Model.leaf) =
    let parts = List.map part (Array.to_list l.parts) in
    { leaf = l; family = families.of_leaf.(i); parts; turns = Option.is_some m.rigid }
  in
  List.mapi leaf (Array.to_list m.leaves)
