open Scc_base
open Scc_exact
open Scc_geometry
open Scc_json

let name_of f i : Json.t = Json.text (f i)

let fault r (f : Polyhedron_fault.t) =
  let vertex = Solid_report.vertex_name r and face = Solid_report.face_name r in
  `Assoc
    [
      ("kind", `String (Polyhedron_fault.kind f));
      ("code", `String (Polyhedron_fault.code f :> string));
      ("message", Json.text (Polyhedron_fault.message ~vertex ~face f));
      ("hint", Json.option Json.text (Polyhedron_fault.hint ~vertex ~face f));
    ]

let condition r (n, witness) =
  let explain w =
    let vertex = Solid_report.vertex_name r and face = Solid_report.face_name r in
    Json.text (Definition_4_3.explain r.Solid_report.paper ~vertex ~face w)
  in
  `Assoc
    [
      ("number", `Int n);
      ("statement", Json.text (Definition_4_3.statement n));
      ("holds", `Bool (Option.is_none witness));
      ("witness", Json.option explain witness);
    ]

let paper (r : Solid_report.t) =
  let p = r.paper in
  `Assoc
    [
      ("holds", `Bool (Definition_4_3.holds p));
      ("conditions", `List (List.map (condition r) p.conditions));
      ("euler", `Int (Definition_4_3.euler p));
      ("euler_ordered", `Int (Definition_4_3.euler_ordered p));
    ]

let matrix (m : Mat.t) = `List [ Json.vec m.r0; Json.vec m.r1; Json.vec m.r2 ]

let mass (m : Mass_properties.t) =
  `Assoc
    [
      ("volume", Json.rat m.volume);
      ("centroid", Json.vec m.centroid);
      ("inertia", matrix m.inertia);
      ("inertia_of_unit_mass", matrix (Mass_properties.inertia ~mass:Rat.one m));
    ]

let geometry (r : Solid_report.t) =
  let vertex (name, position) =
    `Assoc [ ("name", Json.text name); ("position", Json.vec position) ]
  in
  let corner i =
    if i >= 0 && i < Array.length r.set.ifs_vertices then name_of (Solid_report.vertex_name r) i
    else `Int i
  in
  let face (name, corners) =
    `Assoc
      [ ("name", Json.text name); ("corners", `List (List.map corner (Array.to_list corners))) ]
  in
  [
    ("vertices", `List (List.map vertex (Array.to_list r.set.ifs_vertices)));
    ("faces", `List (List.map face (Array.to_list r.set.ifs_faces)));
    ("edges", `Int r.edges);
  ]

let warning (d : Diag.t) = `Assoc [ ("code", `String d.code); ("message", Json.text d.message) ]

let snapped (tolerance, (s : Scc_snap.Snap.snapped)) =
  let short q = Json.text (Decimal.significant ~digits:3 q) in
  let all = List.mapi (fun v by -> (v, by)) (Array.to_list s.moved) in
  let moved = List.filter (fun (_, by) -> Rat.sign by > 0) all in
  let vertex (v, by) = `Assoc [ ("vertex", Json.text (fst s.set.ifs_vertices.(v))); ("by", short by) ] in
  `Assoc
    [
      ("distance", Json.rat tolerance);
      ("moved", `List (List.map vertex moved));
      ("turned_over", `Bool s.turned_over);
      ("bits", `Int s.bits);
    ]

let simplified (o : Scc_snap.Outer.t) =
  `Assoc [ ("faces_of_hull", `Int o.faces); ("beyond", Json.rat o.beyond) ]

let document ~name ~exit ?(mended = []) ?snap ?outer (r : Solid_report.t) =
  let faults, properties, warnings =
    match r.verdict with
    | Accepted (_, m) -> ([], mass m, List.map warning (Solid_report.faults r))
    | Rejected faults -> (List.map (fault r) faults, `Null, [])
  in
  `Assoc
    ([
      ("format", `String "scc-shape");
      ("version", `Int 1);
      ("exit", `Int exit);
      ("name", Json.text name);
      ("accepted", `Bool (Solid_report.accepted r));
      ("faults", `List faults);
      ("warnings", `List warnings);
      ("definition_4_3", paper r);
      ("mass_properties", properties);
    ]
      @ Json_format.written_members Mended_json.field mended
      @ Option.to_list (Option.map (fun s -> ("snapped", snapped s)) snap)
      @ Option.to_list (Option.map (fun o -> ("simplified", simplified o)) outer)
      @ geometry r)
