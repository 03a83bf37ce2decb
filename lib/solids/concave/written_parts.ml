open Scc_exact
open Scc_geometry

let template b name (p : Polyhedron.t) =
  Printf.bprintf b "shape %s {\n  vertices\n" name;
  Array.iter (fun (n, v) -> Printf.bprintf b "    %s %s\n" n (Vec.to_string v)) p.vertices;
  Printf.bprintf b "  faces\n";
  let face (n, corners) =
    let names = List.map (fun v -> fst p.vertices.(v)) (Array.to_list corners) in
    Printf.bprintf b "    %s [%s]\n" n (String.concat ", " names)
  in
  Array.iter face p.faces;
  Printf.bprintf b "}\n\n"

let compound ~name ~mass (t : Parts.t) =
  let b = Buffer.create 4096 in
  let shape part = Printf.sprintf "%s_%s" name part in
  Array.iter (fun (part, p) -> template b (shape part) p) t.parts;
  Printf.bprintf b "compound %s {\n" name;
  let whole = Drawn.volume t.drawn.set in
  let part (part, p) =
    let share = Rat.div (Mass_properties.of_polyhedron p).volume whole in
    Printf.bprintf b "  part %s : %s mass %s\n" part (shape part) (Rat.to_string (Rat.mul mass share))
  in
  Array.iter part t.parts;
  let feature (s : Joints.site) =
    let part, p = t.parts.(s.part) in
    part ^ "." ^ fst p.faces.(s.face)
  in
  List.iter
    (fun (one, other) -> Printf.bprintf b "  glue %s ~ %s\n" (feature one) (feature other))
    (Joints.forest (Array.map snd t.parts));
  Printf.bprintf b "}\n";
  Buffer.contents b

let obj (t : Parts.t) =
  let b = Buffer.create 4096 in
  let first = ref 1 in
  let part (name, (p : Polyhedron.t)) =
    Printf.bprintf b "o %s\n" name;
    let vertex (_, (v : Vec.t)) =
      Printf.bprintf b "v %s %s %s\n" (Rat.to_string v.x) (Rat.to_string v.y) (Rat.to_string v.z)
    in
    Array.iter vertex p.vertices;
    let face (_, corners) =
      let numbers = List.map (fun v -> string_of_int (!first + v)) (Array.to_list corners) in
      Printf.bprintf b "f %s\n" (String.concat " " numbers)
    in
    Array.iter face p.faces;
    first := !first + Array.length p.vertices
  in
  Array.iter part t.parts;
  Buffer.contents b
