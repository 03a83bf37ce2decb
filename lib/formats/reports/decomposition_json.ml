open Scc_geometry
open Scc_concave
open Scc_json

let part (name, (p : Polyhedron.t)) =
  let vertex (name, x) = `Assoc [ ("name", Json.text name); ("position", Json.vec x) ] in
  let corner v = Json.text (fst p.vertices.(v)) in
  let face (name, corners) =
    `Assoc [ ("name", Json.text name); ("corners", `List (List.map corner (Array.to_list corners))) ]
  in
  `Assoc
    [
      ("name", Json.text name);
      ("volume", Json.rat (Mass_properties.of_polyhedron p).volume);
      ("vertices", `List (List.map vertex (Array.to_list p.vertices)));
      ("faces", `List (List.map face (Array.to_list p.faces)));
    ]

let joint (t : Parts.t) (one, other) =
  let site (s : Joints.site) =
    let name, p = t.parts.(s.part) in
    `Assoc [ ("part", Json.text name); ("face", Json.text (fst p.faces.(s.face))) ]
  in
  `List [ site one; site other ]

let document ~name ~exit ~mended (t : Parts.t) =
  `Assoc
    ([
      ("format", `String "scc-decomposition");
      ("version", `Int 1);
      ("exit", `Int exit);
      ("name", Json.text name);
    ]
      @ Json_format.written_members Mended_json.field mended
      @ [
        ("volume", Json.rat (Drawn.volume t.drawn.set));
        ("faces", `Int (Array.length t.drawn.set.ifs_faces));
        ("reflex_edges", `Int (Drawn.reflex_edges t.drawn));
        ("parts", `List (List.map part (Array.to_list t.parts)));
        ("joints", `List (List.map (joint t) (Joints.forest (Array.map snd t.parts))));
      ])
