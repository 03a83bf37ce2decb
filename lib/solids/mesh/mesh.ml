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
    ("glb", "glTF", Gltf.read);
    ("gltf", "glTF", Gltf.read);
    ("3mf", "3MF", Threemf.read);
    ("xyz", "XYZ", Xyz.read);
  ]

let formats = List.map (fun (ending, name, _) -> ("." ^ ending, name)) readers

let by_name path =
  let base = String.lowercase_ascii (Filename.basename path) in
  let ends (ending, _, _) = Filename.check_suffix base ("." ^ ending) in
  Option.map (fun (_, _, read) -> read) (List.find_opt ends readers)

let by_text text =
  let text = String.trim (String.sub text 0 (min 80 (String.length text))) in
  let begins prefix =
    let n = String.length prefix in
    String.length text >= n && String.equal (String.sub text 0 n) prefix
  in
  if List.exists begins [ "OFF"; "COFF"; "NOFF"; "STOFF"; "CNOFF" ] then Some Off.read
  else if begins "glTF" || begins "{" then Some Gltf.read
  else if begins "PK\003\004" then Some Threemf.read
  else if begins "solid" then Some Stl.read
  else if begins "ply" then Some Ply.read
  else if begins "#VRML" || begins "#X3D" then Some Vrml.read
  else if begins "<?xml" || begins "<X3D" then Some X3d.read
  else None

let check_denominator ~path ifs =
  if Polyhedron.too_fine ifs then
    Error
      (Diag.error Code.number_too_large
         (Span.of_file path)
         "the common denominator of the coordinates is too large"
         ~hint:"use decimals, or fractions with few different denominators")
  else Ok ifs

let read ~path text =
  let text = Source.blank_mark text in
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
         (Span.of_file path)
         "the format of this mesh file is not known"
         ~hint:("the formats are told by the ending of the name: " ^ known))
