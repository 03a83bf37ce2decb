open Scc_base
open Scc_exact
open Scc_geometry

module By_corners = Map.Make (struct
    type t = Vec.t list

    let compare = List.compare Vec.compare
  end)

(* The corners from the least position on, in the direction of the list. *)
let from_least corners =
  let rec turn before best = function
    | [] -> best
    | v :: rest as all ->
      let better = match best with (least :: _, _) -> Vec.compare v least < 0 | [], _ -> true in
      turn (v :: before) (if better then (all, List.rev before) else best) rest
  in
  let from, before = turn [] ([], []) corners in
  from @ before

let find (set : Polyhedron.ifs) =
  let inside (_, f) =
    Array.length f >= 3 && Array.for_all (fun v -> v >= 0 && v < Array.length set.ifs_vertices) f in
  let corners (_, f) = List.map (fun v -> snd set.ifs_vertices.(v)) (Array.to_list f) in
  let faces = List.filter inside (Array.to_list set.ifs_faces) in
  let enter known face = By_corners.add (from_least (corners face)) (fst face) known in
  let known = List.fold_left enter By_corners.empty faces in
  let other face = By_corners.find_opt (from_least (List.rev (corners face))) known in
  List.find_map (fun face -> Option.map (fun g -> (fst face, g)) (other face)) faces

let advice ~union set =
  let text (f, g) =
    Printf.sprintf
      "two solids share a face: %s and %s have the same corners, in the two directions; for both together: %s"
      (Visible.line f) (Visible.line g) union
  in
  Option.map text (find set)
