open Scc_data
open Scc_exact
open Scc_geometry
open Scc_decompose
module Points = Hashtbl.Make (Vec)

let place (set : Polyhedron.ifs) v = snd set.ifs_vertices.(v)

(* {1 What faces surround} *)

let numbered points =
  let table = Points.create 256 and list = Growable.create () in
  let number x =
    match Points.find_opt table x with
    | Some k -> k
    | None ->
      let k = Points.length table in
      Points.add table x k;
      Growable.push list x;
      k
  in
  let numbers = List.map (Array.map number) points in
  (Array.init (Growable.length list) (Growable.get list), numbers)

let closed polygons =
  let _, cycles = numbered polygons in
  let balance = Hashtbl.create 256 in
  let add key d = Hashtbl.replace balance key (d + Option.value ~default:0 (Hashtbl.find_opt balance key)) in
  let edge (u, v) = if u < v then add (u, v) 1 else add (v, u) (-1) in
  List.iter (fun cycle -> List.iter edge (Scc_polygon.Polygon.edges cycle)) cycles;
  Hashtbl.fold (fun _ d all -> d = 0 && all) balance true

let outlines (set : Polyhedron.ifs) =
  let inside v = v >= 0 && v < Array.length set.ifs_vertices in
  let fine (_, face) = Array.length face > 2 && Array.for_all inside face in
  if Array.for_all fine set.ifs_faces then
    Some (List.map (fun (_, face) -> Array.map (place set) face) (Array.to_list set.ifs_faces))
  else None

let pieces (set : Polyhedron.ifs) (_, face) =
  let n = Drawn.normal set face in
  let flat v = Rat.sign (Vec.dot n (Vec.sub (place set v) (place set face.(0)))) = 0 in
  if Vec.is_zero n || not (Array.for_all flat face) then None else Drawn.convex_pieces set face n

let mean corners =
  Vec.scale (Rat.div Rat.one (Rat.of_int (List.length corners))) (List.fold_left Vec.add Vec.zero corners)

(* Near the mean of the corners, with short numbers; [None] if there are no floats near it. *)
let near_mean corners =
  let over f = List.fold_left (fun sum (p : Homogeneous.t) -> sum +. f p.near) 0. corners in
  let count = float_of_int (List.length corners) in
  let x = over (fun near -> near.nx) /. count and y = over (fun near -> near.ny) /. count in
  let z = over (fun near -> near.nz) /. count in
  if Float.is_finite x && Float.is_finite y && Float.is_finite z then
    Some (Vec.make (Q.of_float x) (Q.of_float y) (Q.of_float z))
  else None

let within (cell : Cell.t) x =
  let place = Homogeneous.of_vec x in
  List.for_all (fun (f : Cell.facet) -> Plane.side f.plane place < 0) cell

(* An inner point. *)
let middle cell =
  let corners = Cell.corners cell in
  match near_mean corners with
  | Some x when within cell x -> x
  | _ -> mean (List.map Homogeneous.to_vec corners)

(* {1 The surface of parts} *)

let normal_of corners =
  Ivec.primitive (fst (Ivec.of_vec (Drawn.area_vector (Array.get corners) (Array.length corners))))

let plane_of corners = Plane.make (normal_of corners) (Homogeneous.of_vec corners.(0))

type side = { part : int; normal : Vec.t; corners : Vec.t array; box : Float_box.t; plane : Plane.t }

let sides part (p : Polyhedron.t) =
  let side (_, face) =
    let corners = Array.map (fun v -> snd p.vertices.(v)) face in
    let normal = Ivec.to_vec (normal_of corners) in
    { part; normal; corners; box = Boxed.of_points corners; plane = plane_of corners }
  in
  List.map side (Array.to_list p.faces)

module Planes = Hashtbl.Make (Plane)

(* Each face without what faces of other parts cover. *)
let uncovered parts =
  let all = List.concat (List.mapi sides parts) in
  let by_plane = Planes.create 256 in
  List.iter (fun s -> Planes.add by_plane s.plane s) all;
  let rest s =
    let covers o = o.part <> s.part && Float_box.meet o.box s.box in
    let others = List.filter covers (Planes.find_all by_plane (Plane.opposite s.plane)) in
    let without pieces o =
      let turned = Array.of_list (List.rev (Array.to_list o.corners)) in
      List.concat_map (fun piece -> Clipped.difference s.normal piece turned) pieces
    in
    List.fold_left without [ s.corners ] others
  in
  List.concat_map rest all

(* Corners of others on an edge become corners of it. *)
let conforming polygons =
  let points, cycles = numbered polygons in
  let tree = Scc_broad_phase.Box_tree.create () in
  Array.iteri (fun k x -> Scc_broad_phase.Box_tree.insert tree k (Boxed.of_points [| x |])) points;
  let on_edge (u, v) =
    let a = points.(u) and way = Vec.sub points.(v) points.(u) and found = ref [] in
    let look k =
      let to_k = Vec.sub points.(k) a in
      if k <> u && k <> v && Vec.is_zero (Vec.cross way to_k) then
        let t = Rat.div (Vec.dot way to_k) (Vec.norm2 way) in
        if Rat.sign t > 0 && Rat.compare t Rat.one < 0 then found := (t, k) :: !found
    in
    Scc_broad_phase.Box_tree.iter_meeting tree (Boxed.of_points [| a; points.(v) |]) look;
    u :: List.map snd (List.sort (fun (s, _) (t, _) -> Rat.compare s t) !found)
  in
  let whole cycle = Array.of_list (List.concat_map on_edge (Scc_polygon.Polygon.edges cycle)) in
  {
    Polyhedron.ifs_vertices = Array.mapi (fun k x -> (Printf.sprintf "v%d" k, x)) points;
    ifs_faces = Array.of_list (List.mapi (fun k cycle -> (Printf.sprintf "f%d" k, whole cycle)) cycles);
  }

(* {1 Names} *)

type face = { name : string; around : Float_box.t; places : Homogeneous.t array; outline : Vec.t array }

(* The convex pieces of the faces by their planes, the first one first. *)
let faces_by_plane (set : Polyhedron.ifs) polygons =
  let table = Planes.create 256 in
  let enter (name, _) pieces =
    let piece p =
      let around = Boxed.of_points p and places = Array.map Homogeneous.of_vec p in
      Planes.add table (plane_of p) { name; around; places; outline = p }
    in
    List.iter piece pieces
  in
  List.iter2 enter (List.rev (Array.to_list set.ifs_faces)) (List.rev polygons);
  table

let sharing table polygon =
  let plane = plane_of polygon and box = Boxed.of_points polygon in
  let places = Array.map Homogeneous.of_vec polygon in
  let shares f = Float_box.meet box f.around && Planar.share plane f.places places in
  List.filter shares (Planes.find_all table plane)

(* In pieces, each of them in one face. *)
let by_face table polygon =
  match sharing table polygon with
  | [] -> Scc_base.Bug.fail __POS__ "a face of a union that is in no face"
  | [ _ ] -> [ polygon ]
  | several ->
    let n = Ivec.to_vec (normal_of polygon) in
    let cut (found, rest) f =
      let one (found, kept) piece =
        if List.memq f (sharing table piece) then
          (Clipped.common n piece f.outline :: found, Clipped.difference n piece f.outline @ kept)
        else (found, piece :: kept)
      in
      List.fold_left one (found, []) rest
    in
    fst (List.fold_left cut ([], [ polygon ]) several)

(* Pieces of a face have its name, a number at the end of all but one of them. *)
let named (set : Polyhedron.ifs) table (surface : Polyhedron.ifs) =
  let fresh = Fresh.besides set and given = Hashtbl.create 256 and at = Points.create 256 in
  Array.iter (fun (name, x) -> if not (Points.mem at x) then Points.add at x name) set.ifs_vertices;
  let vertex (_, x) = ((match Points.find_opt at x with Some name -> name | None -> Fresh.next fresh "w"), x) in
  let face (_, corners) =
    let name = (List.hd (sharing table (Array.map (place surface) corners))).name in
    if Hashtbl.mem given name then (Fresh.next fresh ~from:2 (name ^ "_"), corners)
    else begin
      Hashtbl.replace given name ();
      (name, corners)
    end
  in
  { Polyhedron.ifs_vertices = Array.map vertex surface.ifs_vertices; ifs_faces = Array.map face surface.ifs_faces }

(* {1 All} *)

let solids ~tick polygons =
  let with_normal p = (Drawn.area_vector (Array.get p) (Array.length p), p) in
  let signed = Array.of_list (List.map with_normal polygons) in
  let tree = Scc_broad_phase.Box_tree.create () in
  Array.iteri (fun k (_, p) -> Scc_broad_phase.Box_tree.insert tree k (Boxed.of_points p)) signed;
  (* Only what the box around a ray upwards meets can be over a point. *)
  let inside cell =
    let x = middle cell and found = ref [] in
    let own = Boxed.of_points [| x |] in
    let side f = Array.init 3 (f own) in
    let high = side Float_box.high in
    high.(2) <- infinity;
    let ray = Float_box.make ~low:(side Float_box.low) ~high in
    Scc_broad_phase.Box_tree.iter_meeting tree ray (fun k -> found := signed.(k) :: !found);
    Within.winding !found x > 0
  in
  List.map Refined.of_cell (Decompose.surrounded ~tick ~inside polygons)

let parts ~tick set =
  let*? outlines = outlines set in
  if outlines = [] || not (closed outlines) then None
  else
    let*? polygons = Option.all (pieces set) (Array.to_list set.ifs_faces) in
    match solids ~tick (List.concat polygons) with
    | [] -> Some ([], set)
    | list ->
      let table = faces_by_plane set polygons in
      Some (list, named set table (conforming (List.concat_map (by_face table) (uncovered list))))
