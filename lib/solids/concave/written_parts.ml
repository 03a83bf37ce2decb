open Scc_data
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

(* The parts of each group that joints connect, in order. *)
let groups joints count =
  let joined = Union_find.create count in
  List.iter (fun ((s : Joints.site), (u : Joints.site)) -> ignore (Union_find.union joined s.part u.part)) joints;
  let members = Array.make count [] in
  for part = count - 1 downto 0 do
    let root = Union_find.find joined part in
    members.(root) <- part :: members.(root)
  done;
  List.sort (List.compare Int.compare) (List.filter (fun list -> list <> []) (Array.to_list members))

let compound ~name ~mass (t : Parts.t) =
  let b = Buffer.create 4096 in
  let shape part = Printf.sprintf "%s_%s" name part in
  Array.iter (fun (part, p) -> template b (shape part) p) t.parts;
  let whole = Drawn.volume t.drawn.set in
  let part k =
    let part, p = t.parts.(k) in
    let share = Rat.div (Mass_properties.of_polyhedron p).volume whole in
    Printf.bprintf b "  part %s : %s mass %s\n" part (shape part) (Rat.to_string (Rat.mul mass share))
  in
  let feature (s : Joints.site) =
    let part, p = t.parts.(s.part) in
    part ^ "." ^ fst p.faces.(s.face)
  in
  let glue (one, other) = Printf.bprintf b "  glue %s ~ %s\n" (feature one) (feature other) in
  let all = groups t.joints (Array.length t.parts) in
  let one k members =
    let own = if List.length all = 1 then name else Printf.sprintf "%s_%d" name (k + 1) in
    Printf.bprintf b "%scompound %s {\n" (if k = 0 then "" else "\n") own;
    List.iter part members;
    List.iter glue (List.filter (fun ((s : Joints.site), _) -> List.mem s.part members) t.joints);
    Printf.bprintf b "}\n"
  in
  List.iteri one all;
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
