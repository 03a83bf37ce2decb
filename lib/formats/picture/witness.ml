open Scc_geometry

type t = {
  badge : string;
  text : string;
  faces : int list;
  edges : (int * int) list;
  vertices : int list;
}

let at ?(faces = []) ?(edges = []) ?(vertices = []) () = (faces, edges, vertices)

let of_fault : Polyhedron_fault.t -> _ = function
  | No_faces | Inward -> at ()
  | Flat f | Short_face f | Turned_face (f, _) | Self_crossing (f, _) | Bad_vertex_index (f, _) ->
    at ~faces:[ f ] ()
  | Open_edge (_, v, w) -> at ~edges:[ (v, w) ] ()
  | Repeated_edge (f, g, v, w) -> at ~faces:[ f; g ] ~edges:[ (v, w) ] ()
  | Same_position (v, w) -> at ~vertices:[ v; w ] ()
  | Unused_vertex v -> at ~vertices:[ v ] ()
  | Off_plane (f, v) | Degenerate_face (f, v) | Not_convex (f, v) | In_plane (f, v) ->
    at ~faces:[ f ] ~vertices:[ v ] ()
  | Coplanar_neighbours (f, g) | Separate_solids (f, g) -> at ~faces:[ f; g ] ()

let of_condition : Definition_4_3.witness -> _ = function
  | Too_few | Collinear | Euler -> at ()
  | Foreign_vertex (f, _) -> at ~faces:[ f ] ()
  | Not_convex_polygon fault -> of_fault fault
  | Equivalent (f, g) -> at ~faces:[ f; g ] ()
  | Angle (_, _, v, w) -> at ~edges:[ (v, w) ] ()

let faults (r : Solid_report.t) = match r.verdict with Accepted _ -> [] | Rejected faults -> faults
let more r = max 0 (List.length (faults r) - Solid_report.max_faults)

let all (r : Solid_report.t) =
  let vertices = Array.length r.set.ifs_vertices in
  let there v = v >= 0 && v < vertices in
  let vertex v = if there v then Solid_report.vertex_name r v else string_of_int v in
  let face = Solid_report.face_name r in
  let make badge text (faces, edges, vertices) =
    let faces = List.sort_uniq Int.compare faces in
    let edges = List.filter (fun (v, w) -> there v && there w) edges in
    { badge; text; faces; edges; vertices = List.filter there vertices }
  in
  let fault i f = make (string_of_int (i + 1)) (Polyhedron_fault.message ~vertex ~face f) (of_fault f) in
  let condition (n, witness) =
    let told w =
      let why = Definition_4_3.explain r.paper ~vertex ~face w in
      make ("c" ^ string_of_int n) (Printf.sprintf "condition %d of Definition 4.3: %s" n why) (of_condition w)
    in
    Option.map told witness
  in
  List.mapi fault (List.filteri (fun i _ -> i < Solid_report.max_faults) (faults r))
  @ List.filter_map condition r.paper.conditions
