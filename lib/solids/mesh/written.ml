open Scc_exact
open Scc_geometry

let number q = Option.value ~default:(Rat.to_string q) (Digits.exact q)

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

let ply (set : Polyhedron.ifs) =
  let b = Buffer.create 4096 in
  Printf.bprintf b "ply\nformat ascii 1.0\nelement vertex %d\n" (Array.length set.ifs_vertices);
  List.iter (Printf.bprintf b "property double %s\n") [ "x"; "y"; "z" ];
  Printf.bprintf b "element face %d\nproperty list uint uint vertex_indices\nend_header\n"
    (Array.length set.ifs_faces);
  vertices b "" set;
  Array.iter (fun (_, c) -> Printf.bprintf b "%d %s\n" (Array.length c) (words string_of_int c)) set.ifs_faces;
  Buffer.contents b

(* The direction of a normal, rounded. It is scaled exactly before, so that no square is beyond all floats. *)
let unit (n : Vec.t) =
  let most = Rat.max (Rat.abs n.x) (Rat.max (Rat.abs n.y) (Rat.abs n.z)) in
  if Rat.sign most = 0 then "0 0 0"
  else
    let part q = Rat.to_float (Rat.div q most) in
    let x = part n.x and y = part n.y and z = part n.z in
    let length = sqrt ((x *. x) +. (y *. y) +. (z *. z)) in
    (* Adding 0 makes 0 of -0. *)
    Printf.sprintf "%.9g %.9g %.9g" ((x /. length) +. 0.) ((y /. length) +. 0.) ((z /. length) +. 0.)

(* Faces are convex: triangles that share the first corner cover them. *)
let stl (set : Polyhedron.ifs) =
  let b = Buffer.create 4096 in
  let place v = snd set.ifs_vertices.(v) in
  let corner (v : Vec.t) = Printf.bprintf b "      vertex %s %s %s\n" (number v.x) (number v.y) (number v.z) in
  let triangle p q r =
    Printf.bprintf b "  facet normal %s\n    outer loop\n" (unit (Vec.cross (Vec.sub q p) (Vec.sub r p)));
    List.iter corner [ p; q; r ];
    Printf.bprintf b "    endloop\n  endfacet\n"
  in
  let face (_, c) =
    for k = 1 to Array.length c - 2 do
      triangle (place c.(0)) (place c.(k)) (place c.(k + 1))
    done
  in
  Printf.bprintf b "solid scc\n";
  Array.iter face set.ifs_faces;
  Printf.bprintf b "endsolid scc\n";
  Buffer.contents b

(* {1 Rounding} *)

let rounded (set : Polyhedron.ifs) =
  let moved = ref 0 and most = ref Rat.zero and beyond = ref None in
  let round q =
    match Digits.rounded q with
    | Some near ->
      let d = Rat.abs (Rat.sub q near) in
      if Rat.sign d > 0 then incr moved;
      most := Rat.max !most d;
      near
    | None ->
      beyond := Some q;
      q
  in
  let one (name, (v : Vec.t)) =
    let x = round v.x in
    let y = round v.y in
    (name, Vec.make x y (round v.z))
  in
  let set = { set with Polyhedron.ifs_vertices = Array.map one set.ifs_vertices } in
  match !beyond with
  | Some _ -> None
  | None -> Some (set, !moved, !most)

let name_of ~path =
  let name = Filename.remove_extension (Filename.basename path) in
  let plain = String.map (function ('a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_') as c -> c | _ -> '_') name in
  match plain with
  | "" -> "Solid"
  | s when s.[0] >= 'a' && s.[0] <= 'z' -> String.capitalize_ascii s
  | s when s.[0] >= 'A' && s.[0] <= 'Z' -> s
  | s -> "Solid" ^ s

let listed before (set : Polyhedron.ifs) after =
  let b = Buffer.create 4096 in
  Printf.bprintf b "%s {\n  vertices\n" before;
  Array.iter (fun (n, v) -> Printf.bprintf b "    %s %s\n" n (Vec.to_string v)) set.ifs_vertices;
  Printf.bprintf b "  faces\n";
  let corner v = fst set.ifs_vertices.(v) in
  let face (n, c) =
    Printf.bprintf b "    %s [%s]\n" n (String.concat ", " (List.map corner (Array.to_list c)))
  in
  Array.iter face set.ifs_faces;
  Printf.bprintf b "}%s\n" after;
  Buffer.contents b

let template ~path set = listed ("shape " ^ name_of ~path) set ""
let drawn ~path set = listed (Printf.sprintf "compound %s = decompose" (name_of ~path)) set " mass 1"

type format = { ending : string; fractions : bool; write : path:string -> Polyhedron.ifs -> string }

let formats =
  [
    { ending = ".off"; fractions = true; write = (fun ~path:_ set -> off set) };
    { ending = ".obj"; fractions = true; write = (fun ~path:_ set -> obj set) };
    { ending = ".stl"; fractions = false; write = (fun ~path:_ set -> stl set) };
    { ending = ".ply"; fractions = false; write = (fun ~path:_ set -> ply set) };
    { ending = ".sc"; fractions = true; write = template };
  ]

let endings = List.map (fun f -> f.ending) formats

let without_decimal (set : Polyhedron.ifs) =
  let lacks q = Option.is_none (Digits.exact q) in
  let bad (_, (v : Vec.t)) = lacks v.x || lacks v.y || lacks v.z in
  Option.map fst (List.find_opt bad (Array.to_list set.ifs_vertices))

let to_file ~path =
  let base = String.lowercase_ascii (Filename.basename path) in
  let writer f set =
    match if f.fractions then None else without_decimal set with
    | None -> Ok (f.write ~path set)
    | Some vertex -> Error vertex
  in
  Option.map writer (List.find_opt (fun f -> Filename.check_suffix base f.ending) formats)
