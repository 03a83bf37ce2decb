open Scc_exact
open Scc_geometry
open Scc_polyhedra
open Scc_offsets
open Scc_calculus
open Scc_semantics
open Scc_state_sets

include Zone_parts

exception Not_affine of string

(* {1 Who collides} *)

(* Rules Contact and Approach. Regions where two parts collide, on each of which the same planes of their obstacle
   hold the offset, and regions where they do not collide. *)
let colliding c region (a, b) =
  if Vec.is_zero (relative_velocity a b) then ([], [ region ])
  else
    let facets = facets c (a, b) in
    match Region.split region (Half_space.collision facets) with
    | None, rest -> ([], rest)
    | Some meet, rest ->
      let cut_one h p =
        Region.where p [ Half_space.on_border h ] @ Region.where p [ Half_space.needs Side.overlap h ]
      in
      let cut regions h = List.concat_map (cut_one h) regions in
      (List.fold_left cut [ meet ] (Half_space.passage facets).entered, rest)

(* {1 What else is looked at} *)

(* The regions on which two parts touch by the same planes, and those on which they do not. *)
let touching c region (a, b) =
  let regions = Touching_cells.make (c.obstacle a.solid b.solid) ~offset:(offset a b) region in
  let judge (p, relation) =
    match (relation : Touching_cells.relation) with
    | Apart -> Either.Right p
    | Touching facets -> Left (p, facets)
    | Interpenetrating -> Scc_base.Bug.fail __POS__ "two bodies interpenetrate"
  in
  List.partition_map judge regions

(* Two channels share the touching pairs of features of the highest dimension among them: so pairs are looked at in
   falling dimension, as long as none of a higher one touches. *)
let by_channels c (a, b) regions ((one : Behaviour.channel), (two : Behaviour.channel)) =
  let offset = offset a b in
  (* Regions with whether some pair touches there. *)
  let look cells (one, two) =
    let touch = Place.within (Feature_offsets.touching c.features one two) offset in
    let cut (region, found) =
      let yes, no = Region.split region touch in
      List.map (fun p -> (p, true)) (Option.to_list yes) @ List.map (fun p -> (p, found)) no
    in
    List.concat_map cut cells
  in
  let rec fall turns region =
    match turns with
    | [] -> [ region ]
    | pairs :: lower ->
      List.fold_left look [ (region, false) ] pairs
      |> List.concat_map (fun (p, found) -> if found then [ p ] else fall lower p)
  in
  let dimension (one, two) = Feature_offsets.dimension c.features one two in
  let turns = Collisions.in_turn dimension (facing (a, b) (one.surface, two.surface)) in
  List.concat_map (fall turns) regions

let by_features c (a, b) region =
  List.fold_left (by_channels c (a, b)) [ region ] (fitting c (a, b))

(* All that two parts touch each other with. *)
let apart_by_touching c regions pair =
  let one region =
    let touch, apart = touching c region pair in
    apart @ List.concat_map (fun (p, _) -> by_features c pair p) touch
  in
  List.concat_map one regions

(* {1 Meetings on the way} *)

(* The features that two parts list for channels that are open and fit, as the offsets at which they meet. *)
let meeting_offsets c (a, b) =
  let offsets (f, g) = Polyhedron.closure (Feature_offsets.touching c.features f g) in
  let of_channels ((one : Behaviour.channel), (two : Behaviour.channel)) =
    List.map offsets (facing (a, b) (one.sites, two.sites))
  in
  List.concat_map of_channels (fitting c (a, b))

(* {1 Collisions} *)

let same_processes (a, b) (a', b') = a.process == a'.process && b.process == b'.process

(* With the pairs that collide on it. *)
let add_pair c cells pair =
  let one (region, hits) =
    let hit, rest = colliding c region pair in
    List.map (fun p -> (p, pair :: hits)) hit @ List.map (fun p -> (p, hits)) rest
  in
  List.concat_map one cells

let of_collisions c all (region, hits) =
  let is_hit pair = List.exists (fun hit -> hit == pair) hits in
  let beside = List.filter (fun pair -> (not (is_hit pair)) && List.exists (same_processes pair) hits) all in
  let regions = List.fold_left (fun regions hit -> List.concat_map (by_features c hit) regions) [ region ] hits in
  List.fold_left (apart_by_touching c) regions beside

(* Reading I-33: who touches may bind, whether they collide or not. *)
let of_contacts c all region =
  List.fold_left (apart_by_touching c) [ region ] (List.filter (fun pair -> fitting c pair <> []) all)

(* {1 Within one process} *)

let of_closings c z regions (p : State.process) =
  let m = Semantics.model c.semantics in
  if not (Closings.may_close m p) then regions
  else
    let may_join (a, b) =
      Closings.free p a.leaf b.leaf && fitting c (a, b) <> []
    in
    List.fold_left (apart_by_touching c) regions (List.filter may_join (Scc_data.Lists.pairs (parts m z p)))

(* A push goes along the only normal of the contact, or else by where exactly the parts are, which is affine in
   nothing that is not known. *)
let of_pushes c z regions (p : State.process) =
  let m = Semantics.model c.semantics in
  let parts = parts m z p in
  let of_bond regions (b : State.bond) =
    let one = of_end parts b.one and two = of_end parts b.two in
    if Place.is_constant (offset one two) then regions
    else
      let one region =
        let touch, _ = touching c region (one, two) in
        let plain (p, facets) =
          match Splits.normal_of_push facets with
          | Some _ -> p
          | None ->
            raise
              (Not_affine "a push along a line that is not known, as the contact has no normal of its own")
        in
        List.map plain touch
      in
      List.concat_map one regions
  in
  Array.fold_left of_bond regions p.bonds

let cells c (z : Zone.t) =
  let m = Semantics.model c.semantics in
  let all = if z.halted then [] else pairs m z in
  let collisions = List.fold_left (add_pair c) [ (z.set, []) ] all |> List.concat_map (of_collisions c all) in
  let collisions =
    if Model.binds_on_contact m then List.concat_map (of_contacts c all) collisions else collisions
  in
  let processes = Array.to_list z.skeleton.processes in
  let closings = List.fold_left (of_closings c z) collisions processes in
  if Parameters.may_push m z.skeleton then List.fold_left (of_pushes c z) closings processes else closings
