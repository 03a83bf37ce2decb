open Scc_exact

type witness =
  | Too_few
  | Foreign_vertex of int * int
  | Collinear
  | Not_convex_polygon of Polyhedron_fault.t
  | Equivalent of int * int
  | Angle of int * int * int * int
  | Euler

type t = {
  vertices : int;
  faces : int;
  edges : int;
  directed_edges : int;
  conditions : (int * witness option) list;
}

let first_some f a =
  let n = Array.length a in
  let rec go i =
    if i >= n then None
    else
      match f i a.(i) with
      | Some _ as found -> found
      | None -> go (i + 1)
  in
  go 0

(* {1 Conditions 2 to 4} *)

let foreign count corners = List.find_opt (fun v -> v < 0 || v >= count) (Array.to_list corners)
let foreign_vertex count f corners = Option.map (fun v -> Foreign_vertex (f, v)) (foreign count corners)

let collinear points =
  let n = Array.length points in
  n = 0
  ||
  let from_first = Array.map (fun p -> Ivec.sub p points.(0)) points in
  match List.find_opt (fun v -> not (Ivec.is_zero v)) (Array.to_list from_first) with
  | None -> true
  | Some direction -> Array.for_all (fun v -> Ivec.is_zero (Ivec.cross direction v)) from_first

let polygon_fault points (f, corners) =
  if Array.length corners < 3 then Some (Polyhedron_fault.Short_face f)
  else
    match Face_check.check points corners with
    | Ok _ -> None
    | Error (Off_plane (i :: _)) -> Some (Off_plane (f, corners.(i)))
    | Error (Off_plane []) -> Scc_base.Bug.fail __POS__ "no corner is to blame"
    | Error (Not_left i) -> Some (Degenerate_face (f, corners.(i)))
    | Error Crossing -> Some (Self_crossing (f, None))

(* {1 Condition 5} *)

(* The place where the least rotation of a tuple starts; each step moves one of the candidates [i], [j] past
   what was compared, so the time is linear. *)
let least_rotation a =
  let n = Array.length a in
  let rec go i j k =
    if i >= n || j >= n || k >= n then Int.min i j
    else
      let x : int = a.((i + k) mod n) and y = a.((j + k) mod n) in
      if x = y then go i j (k + 1)
      else
        let i, j = if x > y then (i + k + 1, j) else (i, j + k + 1) in
        go i (if i = j then j + 1 else j) 0
  in
  if n < 2 then 0 else go 0 1 0

let canonical a =
  let n = Array.length a in
  let start = least_rotation a in
  Array.init n (fun i -> a.((start + i) mod n))

let equivalent faces =
  let keyed = List.rev_map (fun (f, corners) -> (f, canonical corners)) faces in
  let order (f, a) (g, b) = Scc_data.Arrays.compare Int.compare a b <?> fun () -> Int.compare f g in
  let rec neighbours = function
    | (f, a) :: ((g, b) :: _ as rest) ->
      if Scc_data.Arrays.compare Int.compare a b = 0 then Some (Equivalent (f, g)) else neighbours rest
    | [ _ ] | [] -> None
  in
  neighbours (List.sort order keyed)

(* {1 Condition 6} *)

(* On which side of the two faces the dihedral angle is less than 180 degrees. *)
type side = Behind | In_front | Both  (* folded: angles of 0 and 360 degrees *) | Neither

(* At the edge from v to w along [e]; a face that runs along it lies to its left, towards normal x e. *)
let convex_side normals e (f, f_forward) (g, g_forward) =
  let into g forward = Ivec.cross normals.(g) (if forward then e else Ivec.neg e) in
  let seen_from f (g, forward) =
    match Z.sign (Ivec.dot normals.(f) (into g forward)) with
    | -1 -> Behind
    | 1 -> In_front
    | _ -> if Z.sign (Ivec.dot normals.(f) normals.(g)) < 0 then Both else Neither
  in
  match (seen_from f (g, g_forward), seen_from g (f, f_forward)) with
  | Behind, Behind -> Behind
  | In_front, In_front -> In_front
  | Both, Both -> if Bool.equal f_forward g_forward then Neither else Both
  | _ -> Neither

(* The inner side is not known: it is the one on which fewer edges fail. *)
let angle points faces surface =
  let normal corners = if Array.length corners < 3 then Ivec.zero else Face_check.normal points corners in
  let normals = Array.map normal faces in
  let at_edge (not_behind, not_in_front) ((v, w), uses) =
    match uses with
    | [ f; g ] -> (
        let witness = (fst f, fst g, v, w) in
        match convex_side normals (Ivec.sub points.(w) points.(v)) f g with
        | Both -> (not_behind, not_in_front)
        | Behind -> (not_behind, witness :: not_in_front)
        | In_front -> (witness :: not_behind, not_in_front)
        | Neither -> (witness :: not_behind, witness :: not_in_front))
    | _ -> (not_behind, not_in_front)
  in
  let not_behind, not_in_front = List.fold_left at_edge ([], []) (Surface.unordered surface) in
  let fewer =
    if List.compare_lengths not_behind not_in_front <= 0 then not_behind else not_in_front
  in
  match List.rev fewer with
  | [] -> None
  | first :: _ -> Some first

(* {1 All seven} *)

let check (ifs : Polyhedron.ifs) =
  let points, _ = Ivec.of_vecs (Array.map snd ifs.ifs_vertices) in
  let all = Array.map snd ifs.ifs_faces in
  let count = Array.length points in
  let numbered = List.init (Array.length all) (fun f -> (f, all.(f))) in
  let own = List.filter (fun (_, corners) -> Option.is_none (foreign count corners)) numbered in
  let kept = Array.of_list own in
  let numbers = Array.map fst kept and faces = Array.map snd kept in
  let surface = Surface.make count faces in
  let edges = Surface.unordered_count surface in
  let at_edge =
    Option.map
      (fun (f, g, v, w) -> Angle (numbers.(f), numbers.(g), v, w))
      (angle points faces surface)
  in
  let when_ failed witness = if failed then Some witness else None in
  {
    vertices = count;
    faces = Array.length all;
    edges;
    directed_edges = Surface.ordered_count surface;
    conditions =
      [
        (1, when_ (count < 4 || Array.length all < 4) Too_few);
        (2, first_some (foreign_vertex count) all);
        (3, when_ (collinear points) Collinear);
        (4, Option.map (fun f -> Not_convex_polygon f) (List.find_map (polygon_fault points) own));
        (5, equivalent own);
        (6, at_edge);
        (7, when_ (count - edges + Array.length all <> 2) Euler);
      ];
  }

let holds t = List.for_all (fun (_, w) -> Option.is_none w) t.conditions
let euler t = t.vertices - t.edges + t.faces
let euler_ordered t = t.vertices - t.directed_edges + t.faces

let statement = function
  | 1 -> "at least four vertices and four faces"
  | 2 -> "faces name vertices of the set only"
  | 3 -> "the vertices are not collinear"
  | 4 -> "each face is a convex polygon"
  | 5 -> "no two faces are equal up to rotation"
  | 6 -> "angles between neighbouring faces are less than 180 degrees"
  | 7 -> "V - E + F = 2"
  | _ -> Scc_base.Bug.fail __POS__ "Definition 4.3 has seven conditions"

let explain t ~vertex ~face = function
  | Too_few -> Printf.sprintf "there are %d vertices and %d faces" t.vertices t.faces
  | Foreign_vertex (f, v) ->
    Polyhedron_fault.message ~vertex ~face (Polyhedron_fault.Bad_vertex_index (f, v))
  | Collinear -> "all vertices lie on one line"
  | Not_convex_polygon fault -> Polyhedron_fault.message ~vertex ~face fault
  | Equivalent (f, g) -> Printf.sprintf "faces %s and %s are the same" (face f) (face g)
  | Angle (f, g, v, w) ->
    Printf.sprintf "faces %s and %s do not meet at an angle of less than 180 degrees at edge [%s,%s]" (face f)
      (face g) (vertex v) (vertex w)
  | Euler -> Printf.sprintf "%d - %d + %d = %d" t.vertices t.edges t.faces (euler t)
