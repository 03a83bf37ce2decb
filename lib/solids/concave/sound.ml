open Scc_exact
open Scc_geometry
open Scc_polygon
open Scc_decompose

type fault = Structure of Polyhedron_fault.t list | Cut of int * int * Vec.t

let place (set : Polyhedron.ifs) v = snd set.ifs_vertices.(v)

(* {1 Faces by themselves} *)

let structure count faces =
  let outside i = i < 0 || i >= count in
  let face f (_, corners) =
    match List.find_opt outside (Array.to_list corners) with
    | Some i -> Some (Polyhedron_fault.Bad_vertex_index (f, i))
    | None -> if Array.length corners < 3 then Some (Polyhedron_fault.Short_face f) else None
  in
  List.filter_map Fun.id (Array.to_list (Array.mapi face faces))

module Points = Hashtbl.Make (Vec)

let positions (set : Polyhedron.ifs) =
  let used = Array.make (Array.length set.ifs_vertices) false in
  Array.iter (fun (_, corners) -> Array.iter (fun v -> used.(v) <- true) corners) set.ifs_faces;
  let first = Points.create 64 in
  let fault i (_, x) =
    match Points.find_opt first x with
    | Some j -> Some (Polyhedron_fault.Same_position (j, i))
    | None ->
      Points.add first x i;
      if used.(i) then None else Some (Polyhedron_fault.Unused_vertex i)
  in
  List.filter_map Fun.id (Array.to_list (Array.mapi fault set.ifs_vertices))

let flatness set f (_, corners) =
  let n = Drawn.normal set corners in
  let off v = Rat.sign (Vec.dot n (Vec.sub (place set v) (place set corners.(0)))) <> 0 in
  if Vec.is_zero n then Some (Polyhedron_fault.Self_crossing (f, None))
  else
    match List.find_opt off (Array.to_list corners) with
    | Some v -> Some (Polyhedron_fault.Off_plane (f, v))
    | None -> if Option.is_none (Drawn.convex_pieces set corners n)
      then Some (Polyhedron_fault.Self_crossing (f, None)) else None

(* {1 Two faces} *)

type face = {
  number : int;
  corners : int array;
  at : Homogeneous.t array;  (* of the corners *)
  normal : Vec.t;
  plane : Plane.t;
  pieces : (Float_box.t * Vec.t array) list;
}

let is_edge g u v =
  let n = Array.length g.corners in
  let rec from k =
    k < n
    &&
    let a = g.corners.(k) and b = g.corners.((k + 1) mod n) in
    (a = u && b = v) || (a = v && b = u) || from (k + 1)
  in
  from 0

(* All corners of f that g does not have are strictly on one side of the plane of g, and there are such. So f has
   points on this plane at common corners alone, and on its edges between two of them, which are edges of g. *)
let beside f g =
  let n = Array.length f.corners in
  let common = Array.map (fun v -> Array.exists (Int.equal v) g.corners) f.corners in
  let rec one_side k side =
    if k = n then side <> 0
    else if common.(k) then one_side (k + 1) side
    else
      let s = Plane.side g.plane f.at.(k) in
      s <> 0 && side * s >= 0 && one_side (k + 1) s
  in
  let rec edges k =
    k = n
    ||
    let l = (k + 1) mod n in
    ((not (common.(k) && common.(l))) || is_edge g f.corners.(k) f.corners.(l)) && edges (k + 1)
  in
  one_side 0 0 && edges 0

(* What the convex polygon has where the height is not negative. *)
let clip height polygon =
  let n = Array.length polygon in
  let step k =
    let a = polygon.(k) and b = polygon.((k + 1) mod n) in
    let h = height a and i = height b in
    let here = if Rat.sign h >= 0 then [ a ] else [] in
    if Rat.sign h * Rat.sign i < 0 then here @ [ Vec.axpy (Rat.div h (Rat.sub h i)) (Vec.sub b a) a ] else here
  in
  Array.of_list (List.concat (List.init n step))

(* Two convex polygons: points of which what they have in common is the hull. *)
let common one m other =
  let origin = other.(0) in
  let above x = Vec.dot m (Vec.sub x origin) in
  let in_plane = clip (fun x -> Rat.neg (above x)) (clip above one) in
  let k = Array.length other in
  let edge i polygon =
    let c = other.(i) and d = other.((i + 1) mod k) in
    let inner = Vec.cross m (Vec.sub d c) in
    clip (fun x -> Vec.dot inner (Vec.sub x c)) polygon
  in
  List.sort_uniq Vec.compare (Array.to_list (List.fold_left (fun p i -> edge i p) in_plane (List.init k Fun.id)))

let on_segment x (a, b) =
  let way = Vec.sub b a in
  (not (Vec.is_zero way) || Vec.equal x a)
  && Vec.is_zero (Vec.cross way (Vec.sub x a))
  && Rat.sign (Vec.dot way (Vec.sub x a)) >= 0
  && Rat.sign (Vec.dot way (Vec.sub b x)) >= 0

(* What two faces may have in common: edges of both, and corners of both. *)
let shared set f g =
  let edges = Polygon.edges f.corners in
  let both = List.filter (fun (u, v) -> List.mem (v, u) edges
                                        || List.mem (u, v) edges) (Polygon.edges g.corners) in
  let corners = List.filter (fun v -> Array.exists (Int.equal v) f.corners) (Array.to_list g.corners) in
  (List.map (fun (u, v) -> (place set u, place set v)) both, List.map (place set) corners)

(* A point that two faces should not have in common. The common points of two pieces are a point, a segment, or an
   area; at a point it is enough to be on what is shared, and a segment is so if its ends and its parts between all
   corners on it are. The mean tells an area. *)
let stray set f g =
  let edges, corners = shared set f g in
  let allowed x = List.exists (Vec.equal x) corners || List.exists (on_segment x) edges in
  let mean points =
    Vec.scale (Rat.div Rat.one (Rat.of_int (List.length points))) (List.fold_left Vec.add Vec.zero points)
  in
  let of_pieces (box, one) (box', other) =
    let points = if Float_box.meet box box' then common one g.normal other else [] in
    match points with
    | [] -> None
    | first :: _ ->
      let last = List.nth points (List.length points - 1) in
      let on_line = List.filter (fun x -> on_segment x (first, last)) corners in
      let stops = List.sort_uniq Vec.compare (points @ on_line) in
      let middles = List.map (fun (a, b) -> mean [ a; b ]) (Scc_data.Lists.neighbours stops) in
      List.find_opt (fun x -> not (allowed x)) (mean points :: (stops @ middles))
  in
  List.find_map (fun one -> List.find_map (of_pieces one) g.pieces) f.pieces

(* From left to right, those whose boxes meet. *)
let find_cut set faces =
  let least f = Array.fold_left (fun m v -> Rat.min m (place set v).x) (place set f.corners.(0)).x f.corners in
  let sorted = Array.of_list (List.map (fun f -> (least f, f)) faces) in
  Array.stable_sort (fun (a, _) (b, _) -> Rat.compare a b) sorted;
  let sorted = Array.map snd sorted in
  let boxes = Array.map (fun f -> Boxed.of_points (Array.map (place set) f.corners)) sorted in
  let cut (i, j) =
    let f = sorted.(i) and g = sorted.(j) in
    if beside f g || beside g f then None
    else Option.map (fun at -> Cut (Int.min f.number g.number, Int.max f.number g.number, at)) (stray set f g)
  in
  List.find_map cut (Scc_broad_phase.Boxes.pairs boxes)

(* {1 All} *)

let some_structure = function [] -> None | faults -> Some (Structure faults)
let ( <|> ) found next = match found with Some _ -> found | None -> next ()

let faults (set : Polyhedron.ifs) =
  let count = Array.length set.ifs_vertices in
  if Array.length set.ifs_faces = 0 then Some (Structure [ No_faces ])
  else
    some_structure (structure count set.ifs_faces)
    <|> (fun () -> some_structure (positions set))
    <|> (fun () -> some_structure (Surface.edge_faults (Surface.make count (Array.map snd set.ifs_faces))))
    <|> (fun () ->
        some_structure (List.filter_map Fun.id (Array.to_list (Array.mapi (flatness set) set.ifs_faces))))
    <|> (fun () ->
        let places = Array.map (fun (_, x) -> Homogeneous.of_vec x) set.ifs_vertices in
        let face number (_, corners) =
          let normal = Drawn.normal set corners in
          let pieces = Option.value ~default:[] (Drawn.convex_pieces set corners normal) in
          let at = Array.map (fun v -> places.(v)) corners in
          let plane = Plane.make (Ivec.primitive (fst (Ivec.of_vec normal))) at.(0) in
          { number; corners; at; normal; plane; pieces = List.map (fun p -> (Boxed.of_points p, p)) pieces }
        in
        find_cut set (Array.to_list (Array.mapi face set.ifs_faces)))
    <|> fun () -> if Rat.sign (Drawn.volume set) <= 0 then Some (Structure [ Inward ]) else None
