open Scc_semantics

(* Of the groups with something urgent to do, the first in which nobody can be seen, if others could act as
   well. *)
let first_hidden semantics visible present (d : Local.move Network.discrete) =
  let groups = Groups.of_processes semantics present in
  let group (m : Local.move) = Groups.of_leaf groups m.leaf in
  let hidden g = not (List.exists visible (Groups.leaves groups g)) in
  let urgent = List.rev_append d.urgent d.collisions in
  let candidates = List.sort_uniq Int.compare (List.map group urgent) in
  match List.find_opt hidden candidates with
  | None -> None
  | Some g ->
    let inside = List.filter (fun m -> group m = g) in
    let mine = { Network.urgent = inside d.urgent; weak = inside d.weak; collisions = inside d.collisions } in
    let count (d : Local.move Network.discrete) =
      List.length d.urgent + List.length d.weak + List.length d.collisions
    in
    if count mine < count d then Some mine else None
