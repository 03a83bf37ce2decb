open Scc_geometry
open Scc_json
open Scc_picture

(* Corners that are no vertices are told by the faults, and not drawn. *)
let face ~vertices (name, corners) : Json.t =
  let there = List.filter (fun v -> v >= 0 && v < vertices) (Array.to_list corners) in
  `Assoc [ ("name", Json.text name); ("corners", `List (List.map (fun v -> `Int v) there)) ]

let vertex (name, at) : Json.t = `Assoc [ ("name", Json.text name); ("at", Json.vec at) ]

let witness (w : Witness.t) : Json.t =
  let ints list = `List (List.map (fun i -> `Int i) list) in
  `Assoc
    [
      ("badge", `String w.badge);
      ("text", Json.text w.text);
      ("faces", ints w.faces);
      ("edges", `List (List.map (fun (a, b) -> ints [ a; b ]) w.edges));
      ("vertices", ints w.vertices);
    ]

let data ~name (r : Solid_report.t) : Json.t =
  let list f array = `List (List.map f (Array.to_list array)) in
  let vertices = Array.length r.set.ifs_vertices in
  `Assoc
    [
      ("format", `String "scc-solid");
      ("version", `Int 1);
      ("name", Json.text name);
      ("accepted", `Bool (Solid_report.accepted r));
      ("report", Json.text (Solid_report.to_text ~name r));
      ("vertices", list vertex r.set.ifs_vertices);
      ("faces", list (face ~vertices) r.set.ifs_faces);
      ("wrong", `List (List.map witness (Witness.all r)));
      ("more", `Int (Witness.more r));
    ]

let write ~name r put = Page.solid ~title:(name ^ " – scc") (fun put -> put (Json.line (data ~name r))) put
