open Scc_exact
open Scc_polyhedra
open Scc_offsets

type hit = { region : Polyhedron.t; time : Linear.t; tight : int list }

(* The last of the planes that are entered, and who is entered last: a region for each answer. *)
let entered_last within entered =
  let enter cells (f : Half_space.t) =
    let time = Half_space.crossing f in
    let one { region; time = last; tight } =
      let on c time tight = List.map (fun region -> { region; time; tight }) (Region.where region [ c ]) in
      on (Constraint.less time last) last tight
      @ on (Constraint.equals time last) last (f.index :: tight)
      @ on (Constraint.greater time last) time [ f.index ]
    in
    List.concat_map one cells
  in
  match entered with
  | [] -> []
  | f :: rest ->
    List.fold_left enter [ { region = within; time = Half_space.crossing f; tight = [ f.index ] } ] rest

let make o ~offset ~velocity ~limit within =
  let passage = Half_space.passage (Half_space.moving o offset velocity) in
  let conditions = Half_space.first_collision passage ~limit in
  match if Vec.is_zero velocity then (None, [ within ]) else Region.split within conditions with
  | None, rest -> ([], rest)
  | Some meet, rest ->
    let hit { region; time; tight } = { region; time; tight = List.sort Int.compare tight } in
    (List.map hit (entered_last meet passage.entered), rest)
