open Scc_exact
open Scc_geometry

(* The places of the corners, each once. *)
let corners (set : Polyhedron.ifs) =
  let one all v = if v >= 0 && v < Array.length set.ifs_vertices then snd set.ifs_vertices.(v) :: all else all in
  let all = Array.fold_left (fun all (_, f) -> Array.fold_left one all f) [] set.ifs_faces in
  List.sort_uniq Vec.compare all

let is_flat set =
  match corners set with
  | [] -> false
  | first :: rest ->
    let apart = List.map (fun v -> Vec.sub v first) rest in
    let across u v =
      let n = Vec.cross u v in
      if Vec.is_zero n then None else Some n
    in
    let normal = match apart with [] -> None | u :: _ -> List.find_map (across u) apart in
    let in_plane n = List.for_all (fun v -> Rat.sign (Vec.dot n v) = 0) apart in
    Option.fold normal ~none:true ~some:in_plane

let cure = "a sheet bounds no solid: give it a thickness in the program that made it"

let advice set =
  if is_flat set then Some ("all corners are in one plane; " ^ cure) else None
