open Scc_exact
open Scc_geometry
open Scc_polyhedra
open Scc_offsets
open Scc_calculus
open Scc_semantics
open Instant
open Scc_state_sets

type fault = { at : (string * Rat.t) list; reason : reason }
and reason = Interpenetrate of (int * int) * (int * int) | Apart of State.finish * State.finish

(* {1 Rule WellFormed, for all values} *)

let values (m : Model.t) set =
  let point = match Polyhedron.interior_point set with Some p -> p | None -> [||] in
  Array.to_list (Array.mapi (fun i (r : Ranges.range) -> (r.name, point.(i))) m.ranges)

(* Between which numbers the coordinates of a part are, wherever it may be; where there is no such number, None. *)
let extent (z : Zone.t) (part : part) =
  let of_coordinate axis place =
    let reach i = Vec.component axis (Solid.vertex part.solid i) in
    let all = List.init (Array.length part.solid.vertices) reach in
    let least, greatest = Rat.span (List.hd all) all in
    ( Option.map (Rat.add least) (Polyhedron.limit (Polyhedron.infimum z.set place)),
      Option.map (Rat.add greatest) (Polyhedron.limit (Polyhedron.supremum z.set place)) )
  in
  List.map2 of_coordinate [ Vec.X; Y; Z ] (Place.coordinates part.place)

let are_apart one two =
  let before high low =
    match (high, low) with Some high, Some low -> Rat.compare high low <= 0 | _ -> false
  in
  List.exists2 (fun (low, high) (low', high') -> before high low' || before high' low) one two

let overlap c (z : Zone.t) =
  let m = Semantics.model c.semantics in
  let all = List.map (fun part -> (part, extent z part)) (all m z) in
  let of_pair ((a, extent_of_a), (b, extent_of_b)) =
    if (a.leaf = b.leaf && Place.is_constant (offset a b)) || are_apart extent_of_a extent_of_b then None
    else
      match Region.where z.set (Zone_well_formed.overlap c (a, b)) with
      | [] -> None
      | p :: _ -> Some { at = values m p; reason = Interpenetrate ((a.leaf, a.index), (b.leaf, b.index)) }
  in
  List.find_map of_pair (Scc_data.Lists.pairs all)

(* What is bound, and what is glued where that depends on the values. *)
let joints (u : Uncertain.t) (z : Zone.t) =
  let of_glue (g : Uncertain.glue) =
    if Option.is_none (State.home z.skeleton g.leaf) then None
    else Some ({ State.at = g.leaf; site = g.one }, { State.at = g.leaf; site = g.two })
  in
  List.map (fun (b : State.bond) -> (b.one, b.two)) (State.bonds z.skeleton) @ List.filter_map of_glue u.glues

let apart c u (z : Zone.t) =
  let m = Semantics.model c.semantics in
  let parts = all m z in
  let of_joint (f, g) =
    match Difference.pieces z.set (joint c z parts (f, g)) with
    | [] -> None
    | p :: _ -> Some { at = values m p; reason = Apart (f, g) }
  in
  List.find_map of_joint (joints u z)

let known (m : Model.t) (s : State.t) : Uncertain.t =
  let place v = Place.constant 0 v in
  let of_leaf i (_ : Model.leaf) =
    match State.home s i with None -> place Vec.zero | Some p -> place (State.leaf_of p i).position
  in
  { places = Array.mapi of_leaf m.leaves; glues = [] }

(* {1 The zone} *)

let zones c u ~initial ~keeps_time =
  let z = Zone.declared (Semantics.model c.semantics) u initial ~keeps_time in
  match overlap c z with
  | Some fault -> Error fault
  | None -> ( match apart c u z with Some fault -> Error fault | None -> Ok (Passing.settled c z))
