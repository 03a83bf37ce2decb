open Scc_base
open Scc_geometry

let readers =
  [
    ("off", "OFF", Off.read);
    ("obj", "OBJ", Obj.read);
    ("stl", "STL", Stl.read);
    ("ply", "PLY", Ply.read);
    ("wrl", "VRML", Vrml.read);
    ("vrml", "VRML", Vrml.read);
    ("x3dv", "X3D (classic)", Vrml.read);
    ("x3d", "X3D", X3d.read);
  ]

let formats = List.map (fun (ending, name, _) -> ("." ^ ending, name)) readers

let by_name path =
  let base = String.lowercase_ascii (Filename.basename path) in
  let ends (ending, _, _) = Filename.check_suffix base ("." ^ ending) in
  Option.map (fun (_, _, read) -> read) (List.find_opt ends readers)

let by_text text =
  let begins prefix =
    let n = String.length prefix in
    String.length text >= n && String.equal (String.sub text 0 n) prefix
  in
  if List.exists begins [ "OFF"; "COFF"; "NOFF"; "STOFF"; "CNOFF" ] then Some Off.read
  else if begins "solid" then Some Stl.read
  else if begins "ply" then Some Ply.read
  else if begins "#VRML" || begins "#X3D" then Some Vrml.read
  else if begins "<?xml" || begins "<X3D" then Some X3d.read
  else None

(* Everything is over one denominator from here on (Scc_exact.Ivec.of_vecs). Fractions with many different
   denominators would make it so long that a small file needs a lot of memory. *)
let max_bits = 1 lsl 30

let too_fine (ifs : Polyhedron.ifs) =
  let coordinates = 3 * Array.length ifs.ifs_vertices in
  let exceeds d = Z.numbits d > max_bits / Int.max 1 coordinates in
  let add d q = if exceeds d || Z.equal (Q.den q) Z.one then d else Z.lcm d (Q.den q) in
  let add_point d (_, (v : Scc_exact.Vec.t)) = add (add (add d v.x) v.y) v.z in
  exceeds (Array.fold_left add_point Z.one ifs.ifs_vertices)

let check_denominator ~path ifs =
  if too_fine ifs then
    Error
      (Diag.error Code.number_too_large
         (Span.make ~file:path ~start:0 ~stop:0)
         "the common denominator of the coordinates is too large"
         ~hint:"use decimals, or fractions with few different denominators")
  else Ok ifs

let read ~path text =
  let reader =
    match by_name path with
    | Some _ as found -> found
    | None -> by_text text
  in
  match reader with
  | Some read -> Result.bind (read ~path text) (check_denominator ~path)
  | None ->
    let known = String.concat ", " (List.map fst formats) in
    Error
      (Diag.error Code.mesh_format
         (Span.make ~file:path ~start:0 ~stop:0)
         "the format of this mesh file is not known"
         ~hint:("the formats are told by the ending of the name: " ^ known))
