open Scc_geometry
open Scc_polyhedra

type relation = Apart | Touching of int list | Interpenetrating

(* One facet after the other: beyond its plane they are apart, whatever the others say. *)
let make o ~offset within =
  let face (apart, cells) (h : Half_space.t) =
    let meet = Half_space.needs Side.contact h in
    let on_it = Half_space.on_border h and inside = Half_space.needs Side.overlap h in
    let one (region, tight) =
      List.map (fun p -> (p, h.index :: tight)) (Region.where region [ on_it ])
      @ List.map (fun p -> (p, tight)) (Region.where region [ inside ])
    in
    let beyond (region, _) = List.concat_map (fun n -> Region.where region [ n ]) (Constraint.negation meet) in
    (List.concat_map beyond cells @ apart, List.concat_map one cells)
  in
  let start = if Polyhedron.is_empty within then [] else [ (within, []) ] in
  let apart, cells = List.fold_left face ([], start) (Half_space.still o offset) in
  let judged = function
    | p, [] -> (p, Interpenetrating)
    | p, tight -> (p, Touching (List.rev tight))
  in
  List.map (fun p -> (p, Apart)) apart @ List.map judged cells
