open Scc_exact
open Scc_polyhedra
open Scc_state_sets

(* Whether it is an instant of the grid is all that the discrete rules ask of clocks. *)
let by_clocks (z : Zone.t) region =
  let cut regions clock =
    let zero = Linear.constant (Zone.dimension z) Rat.zero in
    let some c = List.concat_map (fun region -> Region.where region [ c ]) regions in
    some (Constraint.equals clock zero) @ some (Constraint.greater clock zero)
  in
  Array.fold_left cut [ region ] z.clocks

let pieces c (z : Zone.t) =
  let set = Zone_well_formed.convex c z in
  if Polyhedron.is_empty set then []
  else
    Zone_well_formed.apart c { z with set }
    |> List.concat_map (by_clocks z)
    |> List.map (fun set -> { z with set })
