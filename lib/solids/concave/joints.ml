open Scc_data
open Scc_geometry
open Scc_decompose

type site = { part : int; face : int }
type side = { site : site; plane : Plane.t; corners : Homogeneous.t array; box : Float_box.t }

module Planes = Hashtbl.Make (Plane)

let sides part (p : Polyhedron.t) =
  let places = Array.map (fun (_, x) -> Homogeneous.of_vec x) p.vertices in
  let side face (_, corners) =
    let box = Boxed.of_points (Array.map (fun v -> snd p.vertices.(v)) corners) in
    let corners = Array.map (fun v -> places.(v)) corners in
    { site = { part; face }; plane = Planar.of_face corners; corners; box }
  in
  Array.to_list (Array.mapi side p.faces)

let reversed corners =
  let n = Array.length corners in
  Array.init n (fun k -> corners.(n - 1 - k))

let forest parts =
  let all = List.concat (List.mapi sides (Array.to_list parts)) in
  let at = Planes.create 256 in
  List.iter (fun s -> Planes.add at s.plane s) all;
  let joined = Union_find.create (Array.length parts) in
  let joints = ref [] in
  let join s =
    let meet other =
      if Union_find.find joined s.site.part <> Union_find.find joined other.site.part
      && Float_box.meet other.box s.box
      && Planar.share s.plane s.corners (reversed other.corners)
      && Union_find.union joined s.site.part other.site.part
      then joints := (s.site, other.site) :: !joints
    in
    List.iter meet (List.rev (Planes.find_all at (Plane.opposite s.plane)))
  in
  List.iter join all;
  List.rev !joints
