open Scc_exact
open Scc_polyhedra
open Scc_property
open Scc_state_sets
open Chance_tree

type limits = {
  horizon : Rat.t option;
  depth : int;
  zones : int;
  stop : unit -> bool;
  attempt : 'a. (unit -> 'a) -> 'a option;
  progress : zones:int -> waiting:int -> depth:int -> Zone.t -> unit;
}

type met = { too_late : bool; too_deep : bool; too_many : bool; stopped : bool }

(* {1 The graph} *)

module Key = struct
  type t = { zone : Zone.t; forms : Linear.t array }

  let make zone = { zone; forms = Zone.coordinates zone }

  let equal a b =
    Zone.dimension a.zone = Zone.dimension b.zone
    && Zone_form.same_kind a.zone b.zone
    && Array.for_all2 Linear.equal a.forms b.forms

  let hash k = Array.fold_left (fun h f -> (h * 31) + Linear.hash f) (Zone_form.hash_kind k.zone) k.forms
end

module Keys = Hashtbl.Make (Key)

type layer = { index : node Keys.t; mutable nodes : node list  (** the last first *) }

type t = {
  context : Instant.context;
  events : Property.event array;
  claims : Chance_claims.t;
  sees_speed : bool;  (** a predicate depends on velocities *)
  parameters : Parameters_seen.t;
  mutable root : tree;
  mutable layers : layer list;  (** the last first *)
  mutable size : int;
  mutable deepest : int;
  mutable transitions : int;
  mutable chain : bool;
  mutable met : met;
}

let new_layer () = { index = Keys.create 64; nodes = [] }

(* Where targets go: those at the end of a movement step wait until all zones of the step are expanded. So zones
   that runs reach by different numbers of collisions become one at its end. *)
type next = { within : layer; after_step : layer }

let later t layer (zone : Zone.t) =
  let zone = if t.sees_speed then zone else Chance_steps.without_old_velocities t.context zone in
  let own, forms = Zone_form.canonical (Parameters_seen.forget t.parameters zone) in
  let key = Key.make own in
  let node =
    match Keys.find_opt layer.index key with
    | Some node -> node
    | None ->
      let node = { zone = own; sets = []; trees = []; values = []; means = [] } in
      Scc_base.Critical.run (fun () ->
          Keys.add layer.index key node;
          layer.nodes <- node :: layer.nodes);
      node
  in
  if not (List.exists (Polyhedron.included own.set) node.sets) then
    node.sets <- Union.add_merged own.set node.sets;
  Later { node; set = own.set; forms }

(* {1 Next steps} *)

let cells = function [ (_, tree) ] -> tree | all -> Cells all

let free t = function
  | [] -> Chance_claims.at_dead_end t.claims
  | [ (_, tree) ] -> tree
  | options ->
    t.chain <- false;
    Free options

(* The zones of one transition, to the next layer. *)
let go t layer (zones : Zone.t list) =
  t.transitions <- t.transitions + 1;
  let one (z : Zone.t) = (z.Zone.set, later t layer z) in
  cells (List.map one (List.concat_map (Chance_steps.settled t.context) zones))

(* What a mean counts of a transition. *)
let counted t (z : Zone.t) source label tree = Chance_claims.after_happening t.claims z ~source label tree

(* Each target of an event is one way, for the states of its set. *)
let events_of t next z all =
  let way (h : Happening.t) = (h.target.Zone.set, counted t z h.source h.label (go t next.within [ h.target ])) in
  List.map way all

let is_step_end : Passing.due -> bool = function
  | Step_end -> true
  | Contact _ | Expiry _ | Split_instant _ | Lots -> false

let pass t next z (cell : Passing.due First.cell) =
  let on ({ region; perhaps; met } : Chance_claims.met) =
    let tree =
      match (met, cell.time) with
      | Some tree, _ -> tree
      | None, None -> Lost
      | None, Some time ->
        let layer = if List.exists is_step_end cell.due then next.after_step else next.within in
        let tree = go t layer (Passing.until t.context z { cell with region }) in
        Chance_claims.after_time t.claims time tree
    in
    (region, Chance_claims.one_of perhaps tree)
  in
  cells (List.map on (Chance_claims.along t.claims z cell))

let stop_at_some_time t next z (cell : Passing.due First.cell) =
  let halted = Passing.within t.context z cell in
  let splits set =
    let halted = { halted with set } in
    let of_region region =
      let happens = Happening.all t.context ~events:t.events halted region in
      match events_of t next halted happens.weak with [] -> [] | options -> [ (region, free t options) ]
    in
    List.concat_map of_region (Instant.cells t.context halted)
  in
  let on ({ region; perhaps; met } : Chance_claims.met) =
    let ways = match met with Some tree -> [ (region, tree) ] | None -> splits region in
    List.map (fun (set, tree) -> (set, Chance_claims.one_of perhaps tree)) ways
  in
  let ways = List.concat_map on (Chance_claims.along_until_stop t.claims z cell halted) in
  List.map (fun (set, tree) -> Stopping (set, tree)) ways

(* The least of the values at all instants is attained if these are finitely many. *)
let stop t next z cell =
  t.chain <- false;
  if Chance_claims.depends_on_instants t.claims then
    let reason = "over starts, a mean of a time or of a number is not known where bonds may break at any time" in
    [ Chance_claims.undecided t.claims reason ]
  else stop_at_some_time t next z cell

let by_itself t next (z : Zone.t) =
  let c = t.context in
  let may_split = Zone_time.splits_at_any_time (Scc_semantics.Semantics.model c.semantics) z in
  let of_region region =
    let happens = Happening.all c ~events:t.events z region in
    let passes = not (Scc_semantics.Network.is_urgent happens) in
    let weak = if passes && may_split then [] else happens.weak in
    let events = events_of t next z (List.concat_map List.rev [ happens.urgent; weak; happens.collisions ]) in
    let of_cell (cell : Passing.due First.cell) =
      let stops = if may_split then stop t next z cell else [] in
      let options = pass t next z cell :: stops in
      (cell.region, free t (events @ List.map (fun tree -> (cell.region, tree)) options))
    in
    if passes then List.map of_cell (Passing.cells c z region) else [ (region, free t events) ]
  in
  cells (List.concat_map of_region (Instant.cells c z))

let by_chance t next (z : Zone.t) =
  let of_region (region, (steps : Chance_steps.t)) =
    let go (way : Chance_steps.way) = counted t z way.source way.label (go t next.within way.targets) in
    let drawn (way : Chance_steps.way) = (Scc_semantics.Transition.chance way.label, go way) in
    match steps with
    | Drawn ways -> (region, Drawn (List.map drawn ways))
    | Chosen ways -> (region, free t (List.map (fun way -> (region, go way)) ways))
  in
  cells (List.map of_region (Chance_steps.all t.context ~events:t.events z))

let on_states t next (z : Zone.t) region =
  let z = { z with set = region } in
  if Chance_steps.pending z then by_chance t next z else by_itself t next z

(* {1 Layers} *)

(* Whether a zone may be expanded; a bound that forbids it is noted. *)
let may_expand t limits ~depth =
  let met = t.met in
  if depth >= limits.depth then t.met <- { met with too_deep = true }
  else if t.size >= limits.zones then t.met <- { met with too_many = true }
  else if met.stopped || limits.stop () then t.met <- { met with stopped = true };
  depth < limits.depth && t.size < limits.zones && not t.met.stopped

let expand t limits next ~depth (z : Zone.t) =
  let further region =
    if may_expand t limits ~depth then begin
      t.size <- t.size + 1;
      (region, on_states t next z region)
    end
    else (region, Open)
  in
  let beyond region =
    t.met <- { t.met with too_late = true };
    (region, Open)
  in
  let on ({ region; perhaps; met } : Chance_claims.met) =
    let ways =
      match met with
      | Some tree -> [ (region, tree) ]
      | None ->
        let timely, late = Chance_claims.not_after_time limits.horizon z region in
        List.map further timely @ List.map beyond late
    in
    List.map (fun (set, tree) -> (set, Chance_claims.one_of perhaps tree)) ways
  in
  cells (List.concat_map on (Chance_claims.judged t.claims z))

(* Some of its states. *)
let shown node = match node.sets with [] -> node.zone | set :: _ -> { node.zone with set }

let rec explore_from t limits ~depth ~after_step layer =
  match (List.rev layer.nodes, after_step.nodes) with
  | [], [] -> ()
  | [], _ :: _ -> explore_from t limits ~depth ~after_step:(new_layer ()) after_step
  | nodes, _ ->
    t.layers <- layer :: t.layers;
    t.deepest <- Int.min depth limits.depth;
    let next = { within = new_layer (); after_step } in
    let size layer = Keys.length layer.index in
    let waiting i = size layer - i - 1 + size next.within + size after_step in
    let of_node i node =
      let of_set set =
        match limits.attempt (fun () -> expand t limits next ~depth { node.zone with Zone.set }) with
        | Some tree -> (set, tree)
        | None ->
          t.met <- { t.met with stopped = true };
          (set, Open)
      in
      limits.progress ~zones:t.size ~waiting:(waiting i) ~depth (shown node);
      node.trees <- List.map of_set node.sets
    in
    List.iteri of_node nodes;
    explore_from t limits ~depth:(depth + 1) ~after_step next.within

let explore_by parameters context question limits zones =
  let claims = Chance_claims.make context question in
  let t =
    {
      context; claims; parameters;
      sees_speed = Chance_claims.see_speed claims;
      events = Chance_claims.events claims;
      root = Lost; layers = []; size = 0; deepest = 0; transitions = 0; chain = true;
      met = { too_late = false; too_deep = false; too_many = false; stopped = false };
    }
  in
  let first = new_layer () in
  let start (z : Zone.t) = (z.set, later t first z) in
  t.root <- cells (List.map start (List.concat_map (Chance_steps.settled context) zones));
  explore_from t limits ~depth:0 ~after_step:(new_layer ()) first;
  t

(* A fault is shown with the start that leads to it, which all parameters tell. *)
let explore context (question : Chance_claims.question) limits zones =
  let by parameters = explore_by parameters context question limits zones in
  try by (Parameters_seen.make context (Chance_claims.predicates question) zones)
  with Law_cells.Bad_law _ | Chance_steps.Bad _ -> by (Parameters_seen.all context)

let question t = Chance_claims.question t.claims
let root t = t.root
let layers ?(most = max_int) t =
  let nodes layers = List.map (fun layer -> layer.nodes) layers in
  let too_many = List.length t.layers - most in
  ( nodes (List.filteri (fun i _ -> i < too_many) t.layers),
    nodes (List.filteri (fun i _ -> i >= too_many) t.layers) )

let solve ?most ~progress t ~forget ~of_node =
  let left_out, layers = layers ?most t in
  (* Of a solution that was given up. *)
  List.iter (List.iter forget) left_out;
  let all = List.fold_left (fun n nodes -> n + List.length nodes) 0 layers and sets = ref 0 in
  let one node =
    progress ~sets:!sets ~all;
    of_node node;
    incr sets
  in
  List.iter (List.iter one) layers;
  progress ~sets:all ~all;
  fun () -> List.iter (List.iter forget) layers

let count_layers t = List.length t.layers
let met t = t.met
let reasons t = Chance_claims.reasons t.claims
let size t = t.size
let transitions t = t.transitions
let depth t = t.deepest
let is_chain t = t.chain
