open Scc_exact
open Scc_geometry
open Scc_polyhedra
open Scc_offsets
open Scc_semantics
open Scc_state_sets

type t = { states : Polyhedron.t; ends : Zone.t }

(* {1 Ways} *)

let moving c z =
  let moves (a, b) = not (Vec.is_zero (Zone_parts.relative_velocity a b)) in
  List.filter moves (Zone_parts.pairs (Semantics.model c.Zone_parts.semantics) z)
  |> List.map (Zone_parts.facets c)

(* The conditions of which one holds iff two parts do not collide before the end: over the start, where the time
   that passes is the last variable. *)
let free n facets =
  let time = Linear.variable n (n - 1) in
  let not_inside h = Constraint.negation (Half_space.needs Side.overlap h) in
  let alone (h : Half_space.t) = not_inside (if Rat.sign h.speed < 0 then Half_space.after time h else h) in
  let { Half_space.entered; left; _ } = Half_space.passage facets in
  let late e = List.map (fun l -> Constraint.at_least (Half_space.crossing e) (Half_space.crossing l)) left in
  List.concat_map alone facets @ List.concat_map late entered

let passings c (z : Zone.t) region =
  let m = Semantics.model c.Zone_parts.semantics in
  let n = Zone.dimension z + 1 in
  let old = Array.init (n - 1) (Linear.variable n) in
  let time = Linear.variable n (n - 1) in
  let set = Polyhedron.embed region ~dimension:n (Array.init (n - 1) Fun.id) in
  let start = Zone.with_variables z ~dimension:n old set in
  let in_time =
    Constraint.greater time (Linear.constant n Rat.zero)
    :: List.map (Constraint.at_most time) (Zone_time.all_left m start)
  in
  let pass regions facets =
    let conditions = free n facets in
    let of_region p =
      if List.exists (Polyhedron.implies p) conditions then [ p ]
      else List.concat_map (fun k -> Region.where p [ k ]) conditions
    in
    List.concat_map of_region regions
  in
  let regions = List.fold_left pass (Region.where start.set in_time) (moving c start) in
  let ends = Zone_time.after m start time in
  List.map (fun set -> { states = set; ends = { ends with set } }) regions

let contacts c { states; ends } =
  List.concat_map (fun facets -> Region.where states (Half_space.collision facets)) (moving c ends)
