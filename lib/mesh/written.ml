open Scc_exact
open Scc_geometry

(* Other programs read decimals. *)
let number q = match Scc_drawing.Decimal.exact q with Some text -> text | None -> Rat.to_string q

let vertices b prefix (set : Polyhedron.ifs) =
  let one (_, (v : Vec.t)) = Printf.bprintf b "%s%s %s %s\n" prefix (number v.x) (number v.y) (number v.z) in
  Array.iter one set.ifs_vertices

let words f corners = String.concat " " (List.map f (Array.to_list corners))

let off (set : Polyhedron.ifs) =
  let b = Buffer.create 4096 in
  let edges = Array.fold_left (fun n (_, c) -> n + Array.length c) 0 set.ifs_faces / 2 in
  Printf.bprintf b "OFF\n%d %d %d\n" (Array.length set.ifs_vertices) (Array.length set.ifs_faces) edges;
  vertices b "" set;
  Array.iter (fun (_, c) -> Printf.bprintf b "%d %s\n" (Array.length c) (words string_of_int c)) set.ifs_faces;
  Buffer.contents b

let obj (set : Polyhedron.ifs) =
  let b = Buffer.create 4096 in
  vertices b "v " set;
  let face (name, c) = Printf.bprintf b "g %s\nf %s\n" name (words (fun v -> string_of_int (v + 1)) c) in
  Array.iter face set.ifs_faces;
  Buffer.contents b

let name_of ~path =
  let name = Filename.remove_extension (Filename.basename path) in
  let plain = String.map (function ('a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_') as c -> c | _ -> '_') name in
  match plain with
  | "" -> "Solid"
  | s when s.[0] >= 'a' && s.[0] <= 'z' -> String.capitalize_ascii s
  | s when s.[0] >= 'A' && s.[0] <= 'Z' -> s
  | s -> "Solid" ^ s

let template ~path (set : Polyhedron.ifs) =
  let name = name_of ~path in
  let b = Buffer.create 4096 in
  Printf.bprintf b "shape %s {\n  vertices\n" name;
  Array.iter (fun (n, v) -> Printf.bprintf b "    %s %s\n" n (Vec.to_string v)) set.ifs_vertices;
  Printf.bprintf b "  faces\n";
  let corner v = fst set.ifs_vertices.(v) in
  let face (n, c) =
    Printf.bprintf b "    %s [%s]\n" n (String.concat ", " (List.map corner (Array.to_list c)))
  in
  Array.iter face set.ifs_faces;
  Printf.bprintf b "}\n";
  Buffer.contents b

let formats = [ (".off", fun ~path:_ set -> off set); (".obj", fun ~path:_ set -> obj set); (".sc", template) ]
let endings = List.map fst formats

let to_file ~path =
  let base = String.lowercase_ascii (Filename.basename path) in
  Option.map
    (fun (_, write) -> write ~path)
    (List.find_opt (fun (ending, _) -> Filename.check_suffix base ending) formats)
