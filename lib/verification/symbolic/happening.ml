open Scc_exact
open Scc_polyhedra
open Scc_offsets
open Scc_calculus
open Scc_semantics
open Scc_state_sets

type t = { source : State.t; label : Transition.label; target : Zone.t }

let of_outcome c ~events (z : Zone.t) region (state : State.t) ~step (o : Transition.outcome) =
  let n = Zone.dimension z in
  let zero = Linear.constant n Rat.zero in
  let skeleton = Zone.skeleton (State.at ~step ~time:None (State.exchange ~gone:o.gone ~come:o.come state)) in
  (* the ends of bonds that are made or released are who goes on *)
  let ends = List.concat_map (fun (b : State.bond) -> [ b.one.at; b.two.at ]) (Transition.bonds o.label) in
  let first (p : State.process) = p.leaves.(0).leaf in
  let new_clocks = List.map first (o.gone @ o.come) in
  let gone leaf = Option.is_none (State.home skeleton leaf) in
  let matches = Scc_evaluate.Event.matches ~source:state o.label in
  let arrived = List.filter (fun i -> matches events.(i)) (List.init (Array.length events) Fun.id) in
  let target =
    {
      z with
      skeleton;
      halted = false;
      arrived;
      set = region;
      ages = Array.mapi (fun i age -> if List.mem i ends || gone i then zero else age) z.ages;
      clocks = Array.mapi (fun i clock -> if List.mem i new_clocks then zero else clock) z.clocks;
      places = Array.mapi (fun i place -> if gone i then Place.constant n Vec.zero else place) z.places;
    }
  in
  List.map (fun target -> { source = state; label = o.label; target }) (Passing.settled c target)

let all (c : Instant.context) ~events z region =
  let point =
    match Polyhedron.point region with
    | Some point -> point
    | None -> Scc_base.Bug.fail __POS__ "an empty region"
  in
  let state = Zone.at z point in
  let step = state.step in
  let happen ?(step = step) = List.concat_map (of_outcome c ~events z region state ~step) in
  let semantics = Instant.semantics_at c z point in
  let of_each kind = List.concat_map (kind semantics) (Array.to_list state.processes) in
  let weak = happen (of_each Network.weak) in
  if z.Zone.halted then { Network.urgent = []; weak; collisions = [] }
  else
    let step = Network.after_collision (Semantics.model c.semantics) step in
    let collisions = happen ~step (Network.together semantics state.processes) in
    { urgent = happen (of_each Network.urgent); weak; collisions }
