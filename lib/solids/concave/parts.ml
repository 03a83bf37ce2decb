open Scc_exact
open Scc_geometry

type t = {
  drawn : Drawn.t;
  parts : (string * Polyhedron.t) array;
  shows : (Drawn.feature, (int * Feature.t) list) Hashtbl.t;
  joints : (Joints.site * Joints.site) list;
}

module Points = Hashtbl.Make (Vec)

(* {1 Names} *)

(* The set does not have w1, w2, … for one place each, and cut1, cut2, … for one face each. *)
let given_names (d : Drawn.t) =
  let at = Points.create 64 in
  Array.iter (fun (n, x) -> if not (Points.mem at x) then Points.add at x n) d.set.ifs_vertices;
  let names = Fresh.besides d.set in
  let vertex x =
    match Points.find_opt at x with
    | Some n -> n
    | None ->
      let n = Fresh.next names "w" in
      Points.add at x n;
      n
  in
  let face shows =
    match shows with
    | Some (Drawn.Region r :: _) -> d.regions.(r).name
    | Some _ | None -> Fresh.next names "cut"
  in
  (vertex, face)

let renamed (vertex, face) (p : Polyhedron.t) features =
  let shows = Array.make (Array.length p.faces) None in
  List.iter (function Feature.Face f, list -> shows.(f) <- Some list | _ -> ()) features;
  let vertices = Array.map (fun (_, x) -> vertex x) p.vertices in
  Polyhedron.renamed ~vertices ~faces:(Array.map face shows) p

let named d p features = renamed (given_names d) p features

let make ?(tick = fun ~left:_ -> ()) ?(names = true) ~limit (d : Drawn.t) pieces =
  let shown = Shown.make d in
  match Refined.parts ~tick ~names shown d ~limit pieces with
  | None -> None
  | Some list ->
    let shows = Hashtbl.create 256 and naming = given_names d in
    let enter k (p, features) =
      let put (feature, carriers) =
        let add c =
          Hashtbl.replace shows c ((k, feature) :: Option.value ~default:[] (Hashtbl.find_opt shows c))
        in
        List.iter add carriers
      in
      List.iter put features;
      (Printf.sprintf "p%d" (k + 1), renamed naming p features)
    in
    let parts = Array.of_list (List.mapi enter list) in
    Some { drawn = d; parts; shows; joints = Joints.forest (Array.map snd parts) }

(* {1 Places} *)

let compare_sites (k, f) (l, g) =
  Int.compare k l <?> fun () -> Feature.compare f g

let inside t feature =
  List.sort_uniq compare_sites (Option.value ~default:[] (Hashtbl.find_opt t.shows feature))

let closed t feature = List.sort_uniq compare_sites (List.concat_map (inside t) (Drawn.closure t.drawn feature))

(* {1 Names as written} *)

type found = Shown of Drawn.feature | Flat | Turned of string | Nothing

let index name array =
  let rec find k =
    if k = Array.length array then None else if String.equal (fst array.(k)) name then Some k else find (k + 1)
  in
  find 0

let vertex t name = index name t.drawn.set.ifs_vertices
let of_vertex t v = if t.drawn.corners.(v) then Shown (Corner v) else Flat

let face_or_vertex t name =
  match (index name t.drawn.set.ifs_faces, vertex t name) with
  | Some f, _ -> Shown (Region t.drawn.region_of_face.(f))
  | None, Some v -> of_vertex t v
  | None, None -> Nothing

let is_edge t u v =
  Array.exists (fun (_, face) -> List.mem (u, v) (Scc_polygon.Polygon.edges face)) t.drawn.set.ifs_faces

let cycle t corners =
  let corners = Array.of_list corners in
  let n = Array.length corners in
  let reversed = Array.init n (fun i -> corners.(n - 1 - i)) in
  let face_of cycle =
    let rec find f =
      if f = Array.length t.drawn.set.ifs_faces then None
      else if Polyhedron.rotation_equivalent (snd t.drawn.set.ifs_faces.(f)) cycle then Some f
      else find (f + 1)
    in
    find 0
  in
  match (face_of corners, face_of reversed) with
  | Some f, _ -> Shown (Region t.drawn.region_of_face.(f))
  | None, Some f -> Turned (fst t.drawn.set.ifs_faces.(f))
  | None, None -> Nothing

let tuple t = function
  | [] -> Nothing
  | [ v ] -> of_vertex t v
  | [ u; v ] -> (
      match Hashtbl.find_opt t.drawn.border_of_edge (Int.min u v, Int.max u v) with
      | Some b -> Shown (Border b)
      | None -> if is_edge t u v then Flat else Nothing)
  | corners -> cycle t corners
