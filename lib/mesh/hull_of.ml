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
