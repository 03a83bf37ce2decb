open Scc_exact
open Scc_geometry
open Scc_polyhedra

type relation = Apart | Touching of int list | Interpenetrating

let where region c =
  let p = Polyhedron.add region c in
  if Polyhedron.is_empty p then [] else [ p ]

(* One facet after the other: beyond its plane they are apart, whatever the others say. *)
let make o ~offset within =
  let x, _, _ = offset in
  let zero = Linear.constant (Linear.dimension x) Rat.zero in
  let face (apart, cells) (i, f) =
    let room = Facet_forms.room offset f in
    let beyond, on_it, inside = Constraint.(less room zero, equals room zero, greater room zero) in
    let one (region, tight) =
      List.map (fun p -> (p, i :: tight)) (where region on_it)
      @ List.map (fun p -> (p, tight)) (where region inside)
    in
    (List.concat_map (fun (p, _) -> where p beyond) cells @ apart, List.concat_map one cells)
  in
  let facets = Array.to_list (Array.mapi (fun i f -> (i, f)) (Obstacle.facets o)) in
  let start = if Polyhedron.is_empty within then [] else [ (within, []) ] in
  let apart, cells = List.fold_left face ([], start) facets in
  let judged = function
    | p, [] -> (p, Interpenetrating)
    | p, tight -> (p, Touching (List.rev tight))
  in
  List.map (fun p -> (p, Apart)) apart @ List.map judged cells
