open Scc_base
open Scc_data
open Scc_exact

type t = {
  vertices : (string * Vec.t) array;
  faces : (string * int array) array;
  edges : (int * int) array;
  topology : Topology.t;
}

type ifs = { ifs_vertices : (string * Vec.t) array; ifs_faces : (string * int array) array }

module Points = Hashtbl.Make (Ivec)

(* {1 The check} *)

let structure_faults count faces =
  let outside i = i < 0 || i >= count in
  let face f =
    match List.find_opt outside (Array.to_list faces.(f)) with
    | Some i -> Some (Polyhedron_fault.Bad_vertex_index (f, i))
    | None -> if Array.length faces.(f) < 3 then Some (Polyhedron_fault.Short_face f) else None
  in
  List.filter_map face (List.init (Array.length faces) Fun.id)

(* E3, and for each vertex the first one at its position: what follows looks through doubled vertices, which
   would otherwise be reported again as open edges. *)
let position_faults points faces =
  let first = Points.create (Array.length points) in
  let used = Array.make (Array.length points) false in
  Array.iter (Array.iter (fun v -> used.(v) <- true)) faces;
  let original i p =
    match Points.find_opt first p with
    | Some j -> j
    | None ->
      Points.add first p i;
      i
  in
  let welded = Array.mapi original points in
  let fault i =
    if welded.(i) <> i then Some (Polyhedron_fault.Same_position (welded.(i), i))
    else if not used.(i) then Some (Polyhedron_fault.Unused_vertex i)
    else None
  in
  (List.filter_map fault (List.init (Array.length points) Fun.id), welded)

(* Of the corners that may be blamed for a face that is not planar, the one that the most such faces blame (a
   displaced vertex spoils all of its faces), and of equals the last. *)
let off_plane_faults count faces blamed =
  let votes = Array.make count 0 in
  let vote v = votes.(v) <- votes.(v) + 1 in
  List.iter (fun (f, places) -> List.iter (fun i -> vote faces.(f).(i)) places) blamed;
  let better v w = if votes.(v) > votes.(w) || (votes.(v) = votes.(w) && v > w) then v else w in
  let fault (f, places) =
    match List.map (fun i -> faces.(f).(i)) places with
    | [] -> Bug.fail __POS__ "a face that is not planar without a corner to blame"
    | v :: others -> Polyhedron_fault.Off_plane (f, List.fold_left better v others)
  in
  List.map fault blamed

let face_faults points faces =
  let sort (blamed, others) f corners =
    match Face_check.check points corners with
    | Ok _ -> (blamed, others)
    | Error (Off_plane places) -> ((f, places) :: blamed, others)
    | Error (Not_left i) -> (blamed, Polyhedron_fault.Degenerate_face (f, corners.(i)) :: others)
    | Error Crossing -> (blamed, Polyhedron_fault.Self_crossing (f, None) :: others)
  in
  let found = ref ([], []) in
  Array.iteri (fun f corners -> found := sort !found f corners) faces;
  let blamed, others = !found in
  let off_plane = off_plane_faults (Array.length points) faces (List.rev blamed) in
  List.rev_append (List.rev off_plane) (List.rev others)

(* Faults at faces and edges. Where only the order of the corners of a face is wrong, that is said once, with the
   right order, and the edges are those of the right order. *)
let surface_faults points faces =
  let open Polyhedron_fault in
  let at_faces = face_faults points faces in
  let out_of_order = function Degenerate_face (f, _) | Self_crossing (f, None) -> Some f | _ -> None in
  let repaired = Reorder.repair points faces (List.filter_map out_of_order at_faces) in
  let is_repaired f = repaired.(f) != faces.(f) in
  let surface = Surface.make (Array.length points) repaired in
  let turned, at_edges =
    List.partition_map
      (function Turned_face (f, corners) when is_repaired f -> Left (f, corners) | fault -> Right fault)
      (Surface.edge_faults surface)
  in
  let right f = Option.value ~default:repaired.(f) (List.assoc_opt f turned) in
  let cure fault =
    match out_of_order fault with Some f when is_repaired f -> Self_crossing (f, Some (right f)) | _ -> fault
  in
  (List.rev_append (List.rev_map cure at_faces) at_edges, surface)

let faults points faces =
  if Array.length faces = 0 then [ Polyhedron_fault.No_faces ]
  else
    match structure_faults (Array.length points) faces with
    | _ :: _ as found -> found
    | [] -> (
        let at_vertices, welded = position_faults points faces in
        let faces = Array.map (Array.map (fun v -> welded.(v))) faces in
        match surface_faults points faces with
        | [], surface -> List.rev_append (List.rev (Convexity.faults points faces surface)) at_vertices
        | found, _ -> List.rev_append (List.rev at_vertices) found)

(* Everything is over one denominator from here on (Ivec.of_vecs). *)
let max_bits = 1 lsl 30

let too_fine ifs =
  let coordinates = 3 * Array.length ifs.ifs_vertices in
  let exceeds d = Z.numbits d > max_bits / Int.max 1 coordinates in
  let add d q = if exceeds d || Z.equal (Q.den q) Z.one then d else Z.lcm d (Q.den q) in
  let add_point d (_, (v : Vec.t)) = add (add (add d v.x) v.y) v.z in
  exceeds (Array.fold_left add_point Z.one ifs.ifs_vertices)

let of_convex ifs =
  let count = Array.length ifs.ifs_vertices and faces = Array.map snd ifs.ifs_faces in
  let edges = Surface.edges (Surface.make count faces) in
  { vertices = ifs.ifs_vertices; faces = ifs.ifs_faces; edges; topology = Topology.make count faces edges }

let of_ifs ifs =
  let points, _ = Ivec.of_vecs (Array.map snd ifs.ifs_vertices) in
  match faults points (Array.map snd ifs.ifs_faces) with
  | [] -> Ok (of_convex ifs)
  | _ :: _ as found -> Error found

let renamed ~vertices ~faces p =
  let name names k (_, x) = (names.(k), x) in
  { p with vertices = Array.mapi (name vertices) p.vertices; faces = Array.mapi (name faces) p.faces }

let to_ifs p = { ifs_vertices = p.vertices; ifs_faces = p.faces }

let transform m p =
  if Rat.sign (Mat.det m) <= 0 then Bug.fail __POS__ "a template through a singular map or a reflection";
  { p with vertices = Array.map (fun (name, v) -> (name, Mat.apply m v)) p.vertices }

(* {1 Definitions 4.1 and 4.2} *)

let rotation_equivalent f g =
  let n = Array.length f in
  let rotated k = 
    let rec same i = i >= n || (Int.equal f.(i) g.((i + k) mod n) && same (i + 1)) in
    same 0
  in
  let rec some k = k < n && (rotated k || some (k + 1)) in
  Array.length g = n && (n = 0 || some 0)

let compare_edge (a, b) (c, d) =
  Int.compare a c <?> fun () -> Int.compare b d

let find_edge p v w =
  let wanted = (Int.min v w, Int.max v w) in
  let rec search low high =
    if low >= high then None
    else
      let middle = (low + high) / 2 in
      let o = compare_edge wanted p.edges.(middle) in
      if o = 0 then Some middle else if o < 0 then search low middle else search (middle + 1) high
  in
  search 0 (Array.length p.edges)

let downgrade p = function
  | Feature.Vertex _ -> []
  | Edge e ->
    let v, w = p.edges.(e) in
    [ Feature.Vertex v; Vertex w ]
  | Face f ->
    let corners = snd p.faces.(f) in
    let n = Array.length corners in
    let side i =
      match find_edge p corners.(i) corners.((i + 1) mod n) with
      | Some e -> Feature.Edge e
      | None -> Bug.fail __POS__ "a side of a face is not among the edges"
    in
    List.sort Feature.compare (List.init n side)

let closure p features =
  let add acc f =
    let below = downgrade p f in
    let vertices = List.concat_map (downgrade p) below in
    f :: List.rev_append below (List.rev_append vertices acc)
  in
  List.sort_uniq Feature.compare (List.fold_left add [] features)

(* {1 Names} *)

let find_index test a =
  let n = Array.length a in
  let rec go i = if i >= n then None else if test a.(i) then Some i else go (i + 1) in
  go 0

let find_vertex p name = find_index (fun (n, _) -> String.equal n name) p.vertices
let find_face p name = find_index (fun (n, _) -> String.equal n name) p.faces
let find_cycle p tuple = find_index (fun (_, f) -> rotation_equivalent f tuple) p.faces

let feature_name p = function
  | Feature.Vertex v -> fst p.vertices.(v)
  | Edge e ->
    let v, w = p.edges.(e) in
    Printf.sprintf "[%s,%s]" (fst p.vertices.(v)) (fst p.vertices.(w))
  | Face f -> fst p.faces.(f)


let equal p q =
  let vertex (m, v) (n, w) = String.equal m n && Vec.equal v w in
  let face (m, f) (n, g) = String.equal m n && Arrays.equal Int.equal f g in
  Arrays.equal vertex p.vertices q.vertices && Arrays.equal face p.faces q.faces
