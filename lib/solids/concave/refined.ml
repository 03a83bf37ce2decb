open Scc_base
open Scc_exact
open Scc_geometry

let solid points =
  let points = List.sort_uniq Vec.compare points in
  let named = List.mapi (fun i x -> (Printf.sprintf "v%d" i, x)) points in
  match Scc_mesh.Hull_of.hull { Polyhedron.ifs_vertices = Array.of_list named; ifs_faces = [||] } with
  | None -> Bug.fail __POS__ "a part without volume"
  | Some set -> (
      match Polyhedron.of_ifs set with
      | Ok polyhedron -> polyhedron
      | Error _ -> Bug.fail __POS__ "a hull that is no polyhedron")

module Places = Hashtbl.Make (Scc_decompose.Homogeneous)

let of_cell (cell : Scc_decompose.Cell.t) =
  let with_place p = (Scc_decompose.Homogeneous.to_vec p, p) in
  let by_place (x, _) (y, _) = Vec.compare x y in
  let points = List.sort by_place (List.map with_place (Scc_decompose.Cell.corners cell)) in
  let numbers = Places.create 32 in
  List.iteri (fun i (_, p) -> Places.add numbers p i) points;
  let face (f : Scc_decompose.Cell.facet) = ("", Array.map (Places.find numbers) f.corners) in
  let ifs_vertices = Array.of_list (List.mapi (fun i (x, _) -> (Printf.sprintf "v%d" i, x)) points) in
  let ifs_faces = Array.of_list (List.map face cell) in
  Polyhedron.of_convex (Scc_mesh.Hull_of.in_order { ifs_vertices; ifs_faces })

let corners (p : Polyhedron.t) = Array.to_list (Array.map snd p.vertices)

let feature_corners (p : Polyhedron.t) : Feature.t -> Vec.t list = function
  | Vertex v -> [ snd p.vertices.(v) ]
  | Edge e ->
    let u, v = p.edges.(e) in
    [ snd p.vertices.(u); snd p.vertices.(v) ]
  | Face f -> List.map (fun v -> snd p.vertices.(v)) (Array.to_list (snd p.faces.(f)))

let height (region : Drawn.region) x = Rat.sub (Vec.dot (Ivec.to_vec region.normal) x) region.level

let divides region points =
  let signs = List.map (fun x -> Rat.sign (height region x)) points in
  List.mem 1 signs && List.mem (-1) signs

(* Where the plane cuts the edges. *)
let crossings region (p : Polyhedron.t) =
  let cut (u, v) =
    let a = snd p.vertices.(u) and b = snd p.vertices.(v) in
    let h = height region a and k = height region b in
    if Rat.sign h * Rat.sign k < 0 then
      Some (Vec.axpy (Rat.div h (Rat.sub h k)) (Vec.sub b a) a)
    else None
  in
  List.filter_map cut (Array.to_list p.edges)

let halves region p =
  let new_corners = crossings region p in
  let half keeps = solid (List.filter (fun x -> keeps (Rat.sign (height region x))) (corners p) @ new_corners) in
  (half (fun s -> s <= 0), half (fun s -> s >= 0))

(* What the regions and borders that a feature shows have on both sides of a plane: the less, the better it divides
   them from each other. *)
let spread (d : Drawn.t) region shows =
  let points : Drawn.feature -> Vec.t list = function
    | Region r -> List.concat_map Array.to_list d.regions.(r).pieces
    | Border b -> List.concat_map (fun (x, y) -> [ x; y ]) d.borders.(b).segments
    | Corner v -> [ snd d.set.ifs_vertices.(v) ]
  in
  List.length (List.filter (fun shown -> divides region (points shown)) shows)

(* The plane that divides best a feature that shows several things. Where none does they are at one place, as two
   borders that touch each other. *)
let dividing (d : Drawn.t) p (feature, shows) =
  let whole = feature_corners p feature in
  let better best region =
    if not (divides region whole) then best
    else
      let spread = spread d region shows in
      match best with
      | Some (least, _) when least <= spread -> best
      | _ -> Some (spread, region)
  in
  match ((feature : Feature.t), shows) with
  | (Face _ | Edge _), _ :: _ :: _ -> Option.map snd (Array.fold_left better None d.regions)
  | _ -> None

let parts ~tick ~names shown (d : Drawn.t) ~limit list =
  let rec refine done_ count left = function
    | _ when count > limit -> None
    | [] -> Some (List.rev done_)
    | p :: rest -> (
        tick ~left;
        let features = if names then Shown.features shown p else Shown.faces shown p in
        match if names then List.find_map (dividing d p) features else None with
        | None -> refine ((p, features) :: done_) count (left - 1) rest
        | Some region ->
          let one, other = halves region p in
          refine done_ (count + 1) (left + 1) (one :: other :: rest))
  in
  let count = List.length list in
  refine [] count count list
