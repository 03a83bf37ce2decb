open Scc_geometry

let renumbered (set : Polyhedron.ifs) =
  { set with ifs_faces = Array.mapi (fun i (_, f) -> ("f" ^ string_of_int i, f)) set.ifs_faces }

let compare_lists = List.compare Int.compare

(* The corners from the least one on. *)
let from_least corners =
  let n = Array.length corners and least = ref 0 in
  Array.iteri (fun i (v : int) -> if v < corners.(!least) then least := i) corners;
  Array.init n (fun i -> corners.((!least + i) mod n))

(* The least of the triangles that corners, from the least one on, make when they are joined to the face one after
   the other. Those at the least corner are between neighbours there. *)
let first_triangle corners =
  let n = Array.length corners in
  let least_from first =
    let least = ref first in
    for i = first + 1 to n - 1 do
      if corners.(i) < corners.(!least) then least := i
    done;
    !least
  in
  let second = least_from 1 in
  if second < n - 1 then [ corners.(0); corners.(second); corners.(least_from (second + 1)) ]
  else
    let third = Array.fold_left Int.min max_int (Array.sub corners 1 (n - 2)) in
    [ corners.(0); third; corners.(second) ]

(* The same whatever the search did: faces come as their triangles would. *)
let in_order (set : Polyhedron.ifs) =
  let faces = Array.map (fun (name, f) -> (name, from_least f)) set.ifs_faces in
  let faces = Array.map (fun (name, f) -> (first_triangle f, (name, f))) faces in
  let faces = List.sort (fun (a, _) (b, _) -> compare_lists a b) (Array.to_list faces) in
  renumbered { set with ifs_faces = Array.of_list (List.map snd faces) }

let hull (set : Polyhedron.ifs) =
  match Hull.triangles (Array.map snd set.ifs_vertices) with
  | None -> None
  | Some triangles ->
    let faces = Array.map (fun f -> ("", f)) (Array.of_list triangles) in
    Some (in_order (Merge_coplanar.merge { set with ifs_faces = faces }))

let flattened ~within (hull : Polyhedron.ifs) =
  renumbered (Merge_coplanar.unite hull (Nearly_flat.groups ~within hull))

(* {1 Hulls of named points} *)

(* Names for that many faces: f1, f2, …, without those of points. *)
let face_names points count =
  let taken name = List.exists (fun (n, _) -> String.equal n name) points in
  let rec from names i left =
    let name = Printf.sprintf "f%d" i in
    if left = 0 then List.rev names
    else if taken name then from names (i + 1) left
    else from (name :: names) (i + 1) (left - 1)
  in
  from [] 1 count

(* Two faces have at most two corners in common. *)
let compare_corners f g =
  let sorted f = List.sort Int.compare (Array.to_list f) in
  let rec compare a b =
    match (a, b) with
    | x :: a, y :: b -> if Int.equal x y then compare a b else Int.compare x y
    | [], _ | _, [] -> List.compare_lengths a b
  in
  compare (sorted f) (sorted g)

let named list =
  match hull { Polyhedron.ifs_vertices = Array.of_list list; ifs_faces = [||] } with
  | None -> None
  | Some hull ->
    let faces = List.sort compare_corners (Array.to_list (Array.map snd hull.ifs_faces)) in
    let names = face_names list (List.length faces) in
    Some { hull with ifs_faces = Array.of_list (List.combine names faces) }
