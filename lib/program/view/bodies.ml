open Scc_geometry
open Scc_calculus
open Scc_json

let list f array = `List (Array.to_list (Array.map f array))
let corners indices = list (fun i -> `Int i) indices

let solid (s : Solid.t) ~template =
  let p = s.polyhedron in
  let face (name, indices) = `Assoc [ ("name", Json.text name); ("corners", corners indices) ] in
  let edge i (a, b) =
    let name = Polyhedron.feature_name p (Edge i) in
    `Assoc [ ("name", Json.text name); ("corners", corners [| a; b |]) ]
  in
  `Assoc
    [
      ("name", Json.text template);
      ("vertices", `List (List.init (Array.length s.vertices) (fun i -> Json.vec (Solid.vertex s i))));
      ("corners", list (fun (name, _) -> Json.text name) p.vertices);
      ("edges", `List (List.mapi edge (Array.to_list p.edges)));
      ("faces", list face p.faces);
    ]

let part ~solids (p : Model.part) =
  `Assoc
    [
      ("name", Json.text p.name);
      ("template", Json.text p.template);
      ("solid", `Int (Rows.add solids (solid p.solid ~template:p.template)));
      ("offset", Json.vec p.offset);
    ]

let leaf ~solids (families : Families.t) i (l : Model.leaf) =
  `Assoc
    [
      ("name", Json.text l.name);
      ("family", `Int families.of_leaf.(i));
      ("template", Json.text l.template);
      ("fixed", `Bool l.fixed);
      ("absorbs", `Bool l.absorbs);
      ("mass", if l.fixed then `Null else Json.rat l.mass);
      ("parts", list (part ~solids) l.parts);
    ]

let families (m : Model.t) = list (fun name -> Json.text name) (Families.of_model m).names

let leaves ~solids (m : Model.t) =
  let families = Families.of_model m in
  `List (List.mapi (leaf ~solids families) (Array.to_list m.leaves))
