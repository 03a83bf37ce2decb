open Scc_exact
open Scc_geometry

type part = {
  name : string;
  template : string;
  solid : Solid.t;
  offset : Vec.t;
  open_offset : Uncertain.place option;
  mass : Rat.t;
}

type leaf = {
  name : string;
  template : string;
  parts : part array;
  fixed : bool;
  absorbs : bool;
  mass : Rat.t;
  law : Law.t;
  law_at : Scc_base.Span.t;
}

type dynamics = Constant_spin | Free_body

type rigid = {
  dynamics : dynamics;
  resolution : Rat.t;
  round_orientation : int option;
}

type steps = Shared | Own | Steady
type collisions = In_turn | Together | Drawn
type binding = On_collision | On_contact
type bonds = Acyclic | Cyclic
type blocked = Bounce | Stop | Wait
type splits = Every of Rat.t | Any_time

type t = {
  leaves : leaf array;
  definitions : Behaviour.definitions;
  timestep : Rat.t;
  splits : splits;
  ranges : Ranges.t;
  keeps_time : bool;
  steered : bool;
  steps : steps;
  collisions : collisions;
  binding : binding;
  bonds : bonds;
  blocked : blocked;
  lots : bool;
  round_velocity : int option;
  rigid : rigid option;
}

let of_each m = m.steered && match m.steps with Own -> true | Shared | Steady -> false
let of_all m = m.steered && not (of_each m)
let keeps_beat m = m.steered && match m.steps with Steady -> true | Shared | Own -> false
let has_turns m = Option.is_some m.rigid || Option.is_some m.round_velocity
let binds_on_contact m = match m.binding with On_contact -> true | On_collision -> false
let closes_rings m = match m.bonds with Cyclic -> true | Acyclic -> false
let stops_walkers m = match m.blocked with Stop | Wait -> true | Bounce -> false
let draws m = Array.exists (fun l -> Law.draws l.law) m.leaves
let leaves_to_chance m = m.lots || draws m
let draws_ties m = match m.collisions with Drawn -> true | In_turn | Together -> false
let decides_by_chance m = leaves_to_chance m || draws_ties m
let straight m = not (m.steered || has_turns m || m.lots)
let absorbs m = Array.exists (fun (l : leaf) -> l.absorbs) m.leaves

let rounds m =
  Option.is_some m.round_velocity || Option.is_some (Option.bind m.rigid (fun r -> r.round_orientation))

let resolution m = Option.map (fun r -> r.resolution) m.rigid
let part_count m = Array.fold_left (fun n l -> n + Array.length l.parts) 0 m.leaves

let site_name m ~leaf (site : Site.t) =
  let part = m.leaves.(leaf).parts.(site.part) in
  part.name ^ "." ^ Polyhedron.feature_name part.solid.polyhedron site.feature

(* A fixed leaf has no mass: its parts count by volume, as if of one density. *)
let same_offset a b =
  let same (x, y, z) (x', y', z') = Scc_polyhedra.Linear.(equal x x' && equal y y' && equal z z') in
  Vec.equal a.offset b.offset && Option.equal same a.open_offset b.open_offset

let leaf_centroid leaf =
  let weight part = if leaf.fixed then part.solid.Solid.volume else part.mass in
  let add (sum, total) part =
    let w = weight part in
    (Vec.axpy w (Vec.add part.offset part.solid.Solid.centroid) sum, Rat.add total w)
  in
  if Array.length leaf.parts = 1 then
    Vec.add leaf.parts.(0).offset leaf.parts.(0).solid.Solid.centroid
  else
    let sum, total = Array.fold_left add (Vec.zero, Rat.zero) leaf.parts in
    Vec.scale (Rat.div Rat.one total) sum
