open Scc_base
open Scc_geometry

(* The readers of files that name no others. *)
let alone read ~files:_ ~path text = read ~path text

(* And that never read what is only near, and leave nothing out. *)
let exact read = alone (fun ~path text -> Result.map (fun set -> (set, [])) (read ~path text))

let is_xml text =
  let text = String.trim (String.sub text 0 (min 80 (String.length text))) in
  String.length text > 0 && text.[0] = '<'

(* Scenes name files of either format. *)
let scene read ~files ~path text =
  let any library ~path:other text =
    if String.equal other path then read library ~path text
    else if is_xml text then X3d.scene library ~path:other text
    else Vrml.scene library ~path:other text
  in
  let prototypes library ~path ~start ~depth text =
    let read = if is_xml text then X3d.prototypes else Vrml.prototypes in
    read library ~path ~start ~depth text
  in
  Scene_solid.read ~files ~scene:any ~prototypes ~path text

let readers =
  [
    ("off", "OFF", exact Off.read);
    ("obj", "OBJ", alone Obj.read);
    ("stl", "STL", alone Stl.read);
    ("ply", "PLY", alone Ply.read);
    ("wrl", "VRML", scene Vrml.scene);
    ("vrml", "VRML", scene Vrml.scene);
    ("x3dv", "X3D (classic)", scene Vrml.scene);
    ("x3d", "X3D", scene X3d.scene);
    ("glb", "glTF", Gltf.read);
    ("gltf", "glTF", Gltf.read);
    ("3mf", "3MF", alone Threemf.read);
    ("xyz", "XYZ", exact Xyz.read);
  ]

let formats = List.map (fun (ending, name, _) -> ("." ^ ending, name)) readers

let by_name path =
  let base = String.lowercase_ascii (Filename.basename path) in
  let ends (ending, _, _) = Filename.check_suffix base ("." ^ ending) in
  Option.map (fun (_, _, read) -> read) (List.find_opt ends readers)

let of_format format =
  Option.map (fun (_, _, read) -> read) (List.find_opt (fun (_, name, _) -> String.equal name format) readers)

let by_text text =
  let text = String.trim (String.sub text 0 (min 80 (String.length text))) in
  let begins prefix =
    let n = String.length prefix in
    String.length text >= n && String.equal (String.sub text 0 n) prefix
  in
  if Off.begins text then of_format "OFF"
  else if begins "glTF" || begins "{" then of_format "glTF"
  else if begins "PK\003\004" then of_format "3MF"
  else if begins "solid" then of_format "STL"
  else if begins "ply" then of_format "PLY"
  else if begins "#VRML" || begins "#X3D" then of_format "VRML"
  else if begins "<?xml" || begins "<X3D" then of_format "X3D"
  else None

(* By the ending of the name, or by its first bytes. *)
let is_drawing ~path text =
  let ends ending = Filename.check_suffix (String.lowercase_ascii path) ending in
  let begins prefix = String.starts_with ~prefix text in
  List.exists ends [ ".svg"; ".png" ] || List.exists begins [ "<svg"; "\137PNG" ]

let unknown ~path text =
  let say ~hint fault = Error (Diag.error Code.mesh_format (Span.of_file path) ~hint "%s" fault) in
  if is_drawing ~path text then
    say "this is a drawing, and a mesh is needed here" ~hint:"scc inflate makes a solid of a drawing"
  else
    let known = String.concat ", " (List.map fst formats) in
    say "the format of this mesh file is not known"
      ~hint:("the formats are told by the ending of the name: " ^ known)

(* Texts of programs that write UTF-16 or compress them. *)
let wrapped ~path text =
  let say ~hint fault = Some (Diag.error Code.mesh_format (Span.of_file path) ~hint "%s" fault) in
  let begins = List.exists (fun prefix -> String.starts_with ~prefix text) in
  let ends = Filename.check_suffix (String.lowercase_ascii path) in
  let binary = List.exists ends [ ".glb"; ".3mf" ] in
  let scene = List.exists ends [ ".x3d"; ".x3dv"; ".wrl"; ".vrml" ] in
  if (not binary) && begins [ "\xff\xfe"; "\xfe\xff"; "<\000"; "\000<" ] then
    say "the text is in UTF-16, which is not read" ~hint:"save it as UTF-8"
  else if (not binary) && begins [ "\x1f\x8b\b" ] then
    say "the file is compressed" ~hint:"decompress it, by gunzip for instance"
  else if scene && String.trim text = "" then
    Some (Diag.error Code.bad_mesh (Span.of_file path) "the file is empty")
  else None

let check ~path ((set : Polyhedron.ifs), warnings) =
  if Array.length set.ifs_vertices = 0 && Array.length set.ifs_faces = 0 then
    Error (Diag.error Code.bad_mesh (Span.of_file path) "the file has no faces and no points")
  else if Polyhedron.too_fine set then
    Error
      (Diag.error Code.number_too_large
         (Span.of_file path)
         "the common denominator of the coordinates is too large"
         ~hint:"use decimals, or fractions with few different denominators")
  else Ok (set, warnings)

let read ~files ~path text =
  let text = Source.blank_mark text in
  let reader =
    match by_name path with
    | None when not (is_drawing ~path text) -> by_text text
    | found -> found
  in
  match (wrapped ~path text, reader) with
  | Some d, _ -> Error d
  | None, Some read -> Result.bind (read ~files ~path text) (check ~path)
  | None, None -> unknown ~path text
