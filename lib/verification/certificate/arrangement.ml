open Scc_exact
open Scc_polyhedra
open Scc_offsets
open Scc_calculus
open Scc_semantics
open Scc_state_sets

let by_sign f region =
  let zero = Linear.constant (Linear.dimension f) Rat.zero in
  List.concat_map
    (fun constraint_ -> Region.where region [ constraint_ ])
    [ Constraint.equals f zero; Constraint.greater f zero; Constraint.less f zero ]

let by_signs forms regions =
  List.fold_left (fun regions f -> List.concat_map (by_sign f) regions) regions forms

(* The features that two leaves may meet in by channels that fit, as sets of offsets. *)
let meeting_features (c : Zone_parts.context) pair =
  let of_channels ((one : Behaviour.channel), (two : Behaviour.channel)) =
    Zone_parts.facing pair (one.surface, two.surface)
  in
  List.concat_map of_channels (Zone_parts.fitting c pair)
  |> List.map (fun (f, g) -> Feature_offsets.touching c.features f g)

let by_features c (a, b) region =
  let offset = Zone_parts.offset a b in
  let cut regions set = by_signs (List.map Constraint.to_form (Place.within set offset)) regions in
  List.fold_left cut [ region ] (meeting_features c (a, b))

let cells (c : Zone_parts.context) (z : Zone.t) =
  let cut regions (((a : Zone_parts.part), (b : Zone_parts.part)) as pair) =
    if a.leaf = b.leaf then regions
    else
      let facets = Zone_parts.facets c pair in
      let rooms = List.map (fun (h : Half_space.t) -> h.room) facets in
      let of_region region =
        let closed, apart = Region.split region (Half_space.contact facets) in
        apart @ List.concat_map (by_features c pair) (by_signs rooms (Option.to_list closed))
      in
      List.concat_map of_region regions
  in
  List.fold_left cut [ z.set ] (Scc_data.Lists.pairs (Zone_parts.all (Semantics.model c.semantics) z))
