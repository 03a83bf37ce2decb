open Scc_exact
open Scc_polyhedra
open Scc_offsets

(* The greatest of some forms: a region for each. *)
let greatest within = function
  | [] -> []
  | f :: rest ->
    let more cells f =
      let one (region, greatest) =
        let on c g = List.map (fun region -> (region, g)) (Region.where region [ c ]) in
        on (Constraint.at_most f greatest) greatest @ on (Constraint.greater f greatest) f
      in
      List.concat_map one cells
    in
    List.fold_left more [ (within, f) ] rest

let cut within (times, conditions) =
  match Region.split within conditions with
  | None, rest -> ([], rest)
  | Some meet, rest -> (greatest meet times, rest)

let of_solids o ~offset ~velocity ~limit within =
  let passage = Half_space.passage (Half_space.moving o offset velocity) in
  if Vec.is_zero velocity then ([], [ within ]) else cut within (Half_space.first_collision passage ~limit)

let of_features offsets ~offset ~velocity ~limit within =
  let x, _, _ = offset in
  let now = Linear.constant (Linear.dimension x) Rat.zero in
  let passage = Half_space.passage (Half_space.of_closed offsets offset velocity) in
  cut within (Half_space.first_meeting passage ~now ~limit)
