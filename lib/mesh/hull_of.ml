open Scc_geometry

let renumbered (set : Polyhedron.ifs) =
  { set with ifs_faces = Array.mapi (fun i (_, f) -> ("f" ^ string_of_int i, f)) set.ifs_faces }

let hull (set : Polyhedron.ifs) =
  match Hull.triangles (Array.map snd set.ifs_vertices) with
  | None -> None
  | Some triangles ->
    (* the same order whatever the search did *)
    let least t = if t.(0) <= t.(1) && t.(0) <= t.(2) then 0 else if t.(1) <= t.(2) then 1 else 2 in
    let turned t = Array.init 3 (fun k -> t.((least t + k) mod 3)) in
    let rec compare i f g =
      if i = 3 then 0
      else
        let c = Int.compare f.(i) g.(i) in
        if c <> 0 then c else compare (i + 1) f g
    in
    let faces = Array.of_list (List.sort (compare 0) (List.rev_map turned triangles)) in
    let numbered = Array.mapi (fun i f -> ("f" ^ string_of_int i, f)) faces in
    let merged = Merge_coplanar.merge { set with ifs_faces = numbered } in
    Some (renumbered merged)

let flattened ~within (hull : Polyhedron.ifs) =
  renumbered (Merge_coplanar.unite hull (Nearly_flat.groups ~within hull))

(* {1 Hulls of named points} *)

(* Names for that many faces: f1, f2, …, without those of points. *)
let face_names points count =
  let taken name = List.exists (fun (n, _) -> String.equal n name) points in
  let rec from i left =
    let name = Printf.sprintf "f%d" i in
    if left = 0 then []
    else if taken name then from (i + 1) left
    else name :: from (i + 1) (left - 1)
  in
  from 1 count

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
