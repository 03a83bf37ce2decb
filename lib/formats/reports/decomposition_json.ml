open Scc_geometry
open Scc_concave
open Scc_json
open Scc_runs
open Json_format

type t = {
  name : string;
  exit : int;
  source : Diag_json.source;
  diagnostics : Scc_base.Diag.t list;
  mended : (string * string) list;
  parts : Parts.t;
}

let vertex = fields [ field "name" text fst; field "position" Shared.vector snd ]

let face =
  let corners ((p : Polyhedron.t), (_, corners)) =
    List.map (fun v -> fst p.vertices.(v)) (Array.to_list corners)
  in
  fields [ field "name" text (fun (_, (name, _)) -> name); field "corners" (list ~least:3 text) corners ]

let part =
  fields
    [
      field "name" (Shared.numbered "p") fst;
      field "volume" Shared.rational (fun (_, p) -> (Mass_properties.of_polyhedron p).volume);
      field "vertices" (array ~least:4 vertex) (fun (_, (p : Polyhedron.t)) -> p.vertices);
      field "faces" (list ~least:4 face) (fun (_, (p : Polyhedron.t)) ->
          List.map (fun face -> (p, face)) (Array.to_list p.faces))
        ~about:
          "Corners counter-clockwise as seen from outside; a face that lies in one of the file has its name.";
    ]

let joint =
  let site (t : Parts.t) (s : Joints.site) =
    let name, (p : Polyhedron.t) = t.parts.(s.part) in
    (name, fst p.faces.(s.face))
  in
  from
    (fun (t, (one, other)) -> [ site t one; site t other ])
    (list ~least:2 ~most:2 (fields [ field "part" text fst; field "face" text snd ]))

let format =
  let set t = t.parts.drawn.set in
  let joints t = List.map (fun j -> (t.parts, j)) t.parts.joints in
  fields
    (Shared.head "scc-decomposition" 1
     @ [
       field "exit" (one_of [ 0 ]) (fun t -> t.exit);
       field "name" text (fun t -> t.name);
       within (fun t -> t.mended) Mended_json.field;
       field "volume" Shared.rational (fun t -> Drawn.volume (set t))
         ~about:"Of the solid, and of all parts together.";
       field "faces" (integer ~least:4 ()) (fun t -> Array.length (set t).ifs_faces) ~about:"Of the file.";
       field "reflex_edges" natural (fun t -> Drawn.reflex_edges t.parts.drawn)
         ~about:"Straight edges at which the solid is not convex.";
       field "parts" (array ~least:1 part) (fun t -> t.parts.parts)
         ~about:"Convex, without common inner points; together they are the solid.";
       field "joints" (list joint) joints ~about:"Pairs of faces that touch, as few as join all parts.";
       field "diagnostics" Diag_json.formats (fun t -> (t.source, t.diagnostics))
         ~about:"Warnings of what is read otherwise, or not, in the files.";
     ])

let document ~name ~exit ~source ~diagnostics ~mended parts =
  write format { name; exit; source; diagnostics; mended; parts }
