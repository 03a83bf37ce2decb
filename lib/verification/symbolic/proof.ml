open Scc_polyhedra
open Scc_semantics
open Scc_property
module Invariant = Scc_certificate.Invariant

type t = { sets : Answers.sets; claims : Invariant.claim list }

let is_about prop = not (Formula.mentions_time (State prop) || Search_sets.asks_for_rest prop)

let may_prove formula =
  let rec any : Plan.t -> bool = function
    | Now _ | Formula _ -> false
    | Possibly (_, p) | Always (_, p) -> is_about p
    | All plans | Any plans -> List.exists any plans
  in
  any (Plan.of_formula formula)

let views (c : Instant.context) (invariant : Invariant.t) =
  let m = Semantics.model c.semantics in
  let node zone : Zone_graph.node =
    let { Zone_steps.cells; _ } = Zone_steps.all c ~events:invariant.events zone in
    { number = 0; zone; depth = 1; parents = []; edges = []; cells; late = []; beyond = None; expanded = true }
  in
  let of_location location =
    let zone, _ = Zone_form.canonical (Invariant.zone m location) in
    List.map node (Plausible.pieces c zone)
  in
  List.concat_map of_location invariant.locations

let make context atoms ~parameters views formula =
  let n = Polyhedron.dimension parameters in
  let all = Union.of_polyhedron parameters and none = Union.empty n in
  let nothing = { sets = { Answers.holds = none; fails = none }; claims = [] } in
  let never prop =
    if not (is_about prop) then none
    else
      let search = Search_sets.make atoms ~parameters:n ~bound:None prop in
      List.iter (Search_sets.look context search) views;
      Union.difference all (Union.union (Search_sets.found search) (Search_sets.open_ search))
  in
  let claim prop sets =
    let values = never prop in
    if Union.is_empty values then nothing else { sets = sets values; claims = [ { never = prop; values } ] }
  in
  let rec of_plan : Plan.t -> t = function
    | Now _ | Formula _ -> nothing
    | Possibly (_, p) -> claim p (fun fails -> { holds = none; fails })
    | Always (_, p) -> claim (Formula.negate p) (fun holds -> { holds; fails = none })
    | All plans ->
      let both { sets = a; claims } { sets = b; claims = more } =
        let sets = { Answers.holds = Union.inter a.holds b.holds; fails = Union.union a.fails b.fails } in
        { sets; claims = claims @ more }
      in
      List.fold_left both { sets = { holds = all; fails = none }; claims = [] } (List.map of_plan plans)
    | Any plans ->
      let either { sets = a; claims } { sets = b; claims = more } =
        let sets = { Answers.holds = Union.union a.holds b.holds; fails = Union.inter a.fails b.fails } in
        { sets; claims = claims @ more }
      in
      List.fold_left either { sets = { holds = none; fails = all }; claims = [] } (List.map of_plan plans)
  in
  of_plan (Plan.of_formula formula)
