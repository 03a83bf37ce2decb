open Scc_base
open Scc_data

let find ~size ~inside arcs =
  let components =
    Strong_components.compute ~size ~inside ~successors:(fun i -> Array.of_list (List.map fst (arcs i)))
  in
  let number = Strong_components.number components in
  let together i (j, _) = Int.equal (number i) (number j) in
  let cycle i (j, choice) =
    let successors u = List.filter (together u) (arcs u) in
    match Shortest_path.find ~successors ~from:j ~goal:(Int.equal i) with
    | None -> Bug.fail __POS__ "a component is not connected"
    | Some back -> (i, (i, choice) :: back)
  in
  let rec go i =
    if i = size then None
    else
      match if inside i then List.find_opt (together i) (arcs i) else None with
      | Some arc -> Some (cycle i arc)
      | None -> go (i + 1)
  in
  go 0
