open Scc_exact
open Scc_geometry
open Scc_decompose

module Points = Hashtbl.Make (Vec)
module Planes = Hashtbl.Make (Plane)

type t = {
  drawn : Drawn.t;
  planes : Plane.t array;  (* of regions *)
  by_plane : int Planes.t;  (* the regions of each plane *)
  by_sides : (int * int, int) Hashtbl.t;  (* the borders between two regions *)
  corner_at : int Points.t;
  pieces : (Float_box.t * Vec.t array * Homogeneous.t array) list array;  (* of regions *)
  boxes : Scc_broad_phase.Box_tree.t;  (* of regions *)
}

let make (d : Drawn.t) =
  let by_plane = Planes.create 64 and by_sides = Hashtbl.create 64 and corner_at = Points.create 64 in
  let parallel r s = Ivec.is_zero (Ivec.cross d.regions.(r).normal d.regions.(s).normal) in
  (* More than two meet where a solid touches itself. Borders between two that are not parallel are on one line. *)
  let beside b r s = if r < s && not (parallel r s) then Hashtbl.add by_sides (r, s) b in
  Array.iteri
    (fun b (border : Drawn.border) -> List.iter (fun r -> List.iter (beside b r) border.between) border.between)
    d.borders;
  Array.iteri (fun v corner -> if corner then Points.replace corner_at (snd d.set.ifs_vertices.(v)) v) d.corners;
  let plane (region : Drawn.region) = Plane.make region.normal (Homogeneous.of_vec (List.hd region.pieces).(0)) in
  let planes = Array.map plane d.regions in
  Array.iteri (fun r plane -> Planes.add by_plane plane r) planes;
  let piece p = (Boxed.of_points p, p, Array.map Homogeneous.of_vec p) in
  let pieces_of (region : Drawn.region) = List.map piece region.pieces in
  let pieces = Array.map pieces_of d.regions and boxes = Scc_broad_phase.Box_tree.create () in
  let whole pieces = Float_box.hull (Array.of_list (List.map (fun (box, _, _) -> box) pieces)) in
  Array.iteri (fun r list -> Scc_broad_phase.Box_tree.insert boxes r (whole list)) pieces;
  { drawn = d; planes; by_plane; by_sides; corner_at; pieces; boxes }

(* The regions in whose planes all points are, and whose boxes meet the box around them. *)
let regions_at t box points =
  let places = Array.map Homogeneous.of_vec points and found = ref [] in
  let add r = if Array.for_all (fun p -> Plane.side t.planes.(r) p = 0) places then found := r :: !found in
  Scc_broad_phase.Box_tree.iter_meeting t.boxes box add;
  List.sort Int.compare !found

(* The pieces of a region whose boxes meet a box. *)
let pieces_near t box r = List.filter (fun (own, _, _) -> Float_box.meet box own) t.pieces.(r)

let cyclic points =
  let n = Array.length points in
  List.init n (fun k -> (points.(k), points.((k + 1) mod n)))

(* {1 Along a segment from a to b: parts of it as intervals from 0 to 1} *)

let clip n piece (a, b) =
  let way = Vec.sub b a in
  let cut range (c, d) =
    match range with
    | None -> None
    | Some (low, high) ->
      let inner = Vec.cross n (Vec.sub d c) in
      let start = Vec.dot inner (Vec.sub a c) and slope = Vec.dot inner way in
      let s = Rat.sign slope in
      if s = 0 then if Rat.sign start >= 0 then range else None
      else
        let zero = Rat.neg (Rat.div start slope) in
        let low = if s > 0 then Rat.max low zero else low and high = if s < 0 then Rat.min high zero else high in
        if Rat.compare low high < 0 then Some (low, high) else None
  in
  List.fold_left cut (Some (Rat.zero, Rat.one)) (cyclic piece)

(* For a segment on the line of a and b. *)
let common (a, b) (c, d) =
  let way = Vec.sub b a in
  let at x = Rat.div (Vec.dot way (Vec.sub x a)) (Vec.norm2 way) in
  let s = at c and t = at d in
  let low = Rat.max Rat.zero (Rat.min s t) and high = Rat.min Rat.one (Rat.max s t) in
  if Rat.compare low high < 0 then Some (low, high) else None

let length intervals =
  let sorted = List.sort (fun (a, _) (b, _) -> Rat.compare a b) intervals in
  let add (sum, reached) (low, high) =
    let low = Rat.max low reached in
    if Rat.compare low high < 0 then (Rat.add sum (Rat.sub high low), high) else (sum, reached)
  in
  fst (List.fold_left add (Rat.zero, Rat.zero) sorted)

(* {1 Features of parts} *)

let of_face t (p : Polyhedron.t) places corners =
  let box = Boxed.of_points (Array.map (fun v -> snd p.vertices.(v)) corners) in
  let polygon = Array.map (fun v -> places.(v)) corners in
  let plane = Planar.of_face polygon in
  let overlap r = List.exists (fun (_, _, piece) -> Planar.share plane piece polygon) (pieces_near t box r) in
  Planes.find_all t.by_plane plane
  |> List.filter overlap
  |> List.sort Int.compare
  |> List.map (fun r -> Drawn.Region r)

let borders_of t regions =
  let pairs = List.concat_map (fun r -> List.filter_map (fun s -> if r < s
                                                          then Some (r, s) else None) regions) regions in
  List.concat_map (fun pair -> Hashtbl.find_all t.by_sides pair) pairs

let of_edge t (a, b) =
  let box = Boxed.of_points [| a; b |] in
  let regions = regions_at t box [| a; b |] in
  let on_border k = List.filter_map (common (a, b)) t.drawn.borders.(k).segments in
  let borders =
    List.filter_map
      (fun k -> match on_border k with [] -> None | list -> Some (k, list))
      (List.sort_uniq Int.compare (borders_of t regions))
  in
  let inside r =
    let n = Ivec.to_vec t.drawn.regions.(r).normal in
    let all = List.filter_map (fun (_, piece, _) -> clip n piece (a, b)) (pieces_near t box r) in
    let beside = List.filter (fun (k, _) -> List.mem r t.drawn.borders.(k).between) borders in
    Rat.compare (length all) (length (List.concat_map snd beside)) > 0
  in
  List.map (fun (k, _) -> Drawn.Border k) borders
  @ List.map (fun r -> Drawn.Region r) (List.filter inside regions)

let on_segment x (c, d) =
  let way = Vec.sub d c in
  Vec.is_zero (Vec.cross way (Vec.sub x c))
  && Rat.sign (Vec.dot way (Vec.sub x c)) >= 0
  && Rat.sign (Vec.dot way (Vec.sub d x)) >= 0

let of_vertex t x =
  match Points.find_opt t.corner_at x with
  | Some v -> [ Drawn.Corner v ]
  | None -> (
      let box = Boxed.of_points [| x |] in
      let regions = regions_at t box [| x |] in
      let on k = List.exists (on_segment x) t.drawn.borders.(k).segments in
      match List.filter on (List.sort_uniq Int.compare (borders_of t regions)) with
      | _ :: _ as borders -> List.map (fun k -> Drawn.Border k) borders
      | [] ->
        let place = Homogeneous.of_vec x in
        let holds r (_, _, piece) = Planar.holds t.planes.(r) piece place in
        let inside r = List.exists (holds r) (pieces_near t box r) in
        List.map (fun r -> Drawn.Region r) (List.filter inside regions))

let shown list = List.filter (fun (_, shows) -> shows <> []) list

let faces t (p : Polyhedron.t) =
  let places = Array.map (fun (_, x) -> Homogeneous.of_vec x) p.vertices in
  let face f (_, corners) = (Feature.Face f, of_face t p places corners) in
  shown (Array.to_list (Array.mapi face p.faces))

let features t (p : Polyhedron.t) =
  let at v = snd p.vertices.(v) in
  let edges =
    List.mapi (fun e (u, v) -> (Feature.Edge e, of_edge t (at u, at v))) (Array.to_list p.edges)
  in
  let vertices = List.init (Array.length p.vertices) (fun v -> (Feature.Vertex v, of_vertex t (at v))) in
  faces t p @ shown (edges @ vertices)
