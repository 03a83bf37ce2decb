open Scc_exact
open Scc_polyhedra
open Scc_property
open Scc_state_sets
module Truth = Scc_ctl.Truth

type question = { claim : Property.prop; goal : Property.prop; bound : Property.bound }

type limits = {
  horizon : Rat.t option;
  depth : int;
  zones : int;
  stop : unit -> bool;
  progress : zones:int -> waiting:int -> depth:int -> unit;
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

(* What follows the states of a set. *)
type tree =
  | Won
  | Lost
  | Open  (** not known *)
  | Cells of (Polyhedron.t * tree) list  (** disjoint, and together the set *)
  | Drawn of (Rat.t * tree) list
  | Free of (Polyhedron.t * tree) list  (** ways to go on, each for the states of a set *)
  | Stopping of Polyhedron.t * tree
  (** one way to go on for each value of one more variable, the last one, that is in the set *)
  | Later of node * Polyhedron.t

(* Zones of one kind with the same forms. Each set of a node is expanded by itself. *)
and node = {
  zone : Zone.t;
  mutable sets : Polyhedron.t list;
  mutable trees : (Polyhedron.t * tree) list;  (** of each set, when it is expanded *)
  mutable values : (Polyhedron.t * Piecewise.t) list;  (** of each set, while the layer before is solved *)
}

type layer = { index : node Keys.t; mutable nodes : node list  (** the last first *) }

type t = {
  context : Instant.context;
  events : Property.event array;
  question : question;
  goal : Atoms.view -> (Polyhedron.t * Truth.t) list;
  claim : Atoms.view -> (Polyhedron.t * Truth.t) list;
  mutable root : tree;
  mutable layers : layer list;  (** the last first *)
  mutable reasons : string list;
  mutable size : int;
  mutable transitions : int;
  mutable chain : bool;
  mutable met : met;
}

let new_layer () = { index = Keys.create 64; nodes = [] }

let later next (zone : Zone.t) =
  let key = Key.make zone in
  let node =
    match Keys.find_opt next.index key with
    | Some node -> node
    | None ->
      let node = { zone; sets = []; trees = []; values = [] } in
      Keys.add next.index key node;
      next.nodes <- node :: next.nodes;
      node
  in
  if not (List.exists (Polyhedron.included zone.set) node.sets) then
    node.sets <- Union.add_merged zone.set node.sets;
  Later (node, zone.set)

(* {1 Predicates} *)

let undecided t reason =
  if not (List.mem reason t.reasons) then t.reasons <- reason :: t.reasons;
  Open

(* The regions where the elapsed time is within the bound, after [passed], and the others. *)
let in_time t (z : Zone.t) region =
  let bound = t.question.bound in
  match z.time with
  | None -> ([ region ], [])
  | Some time ->
    let known q = Linear.constant (Zone.dimension z) q in
    let low = if Rat.sign bound.low > 0 then [ Constraint.at_least time (known bound.low) ] else [] in
    let high = List.map (fun h -> Constraint.at_most time (known h)) (Option.to_list bound.high) in
    let yes, no = Region.split region (low @ high) in
    (Option.to_list yes, no)

let not_after_time horizon (z : Zone.t) region =
  match (z.time, horizon) with
  | Some time, Some h ->
    let yes, no = Region.split region [ Constraint.at_most time (Linear.constant (Zone.dimension z) h) ] in
    (Option.to_list yes, no)
  | None, _ | _, None -> ([ region ], [])

(* What is known at an instant: [None] where the run has to go on. *)
let judged t (z : Zone.t) =
  let view set = { Atoms.zone = { z with set }; passing = false; quiescent = [] } in
  let by_claim region =
    let one (p, (truth : Truth.t)) =
      (p, match truth with True -> None | False -> Some Lost | Undecided reason -> Some (undecided t reason))
    in
    List.map one (t.claim (view region))
  in
  let by_goal (p, (truth : Truth.t)) =
    match truth with
    | Undecided reason -> [ (p, Some (undecided t reason)) ]
    | False -> by_claim p
    | True ->
      let yes, no = in_time t z p in
      List.map (fun q -> (q, Some Won)) yes @ List.concat_map by_claim no
  in
  let timely, late = not_after_time t.question.bound.high z z.set in
  List.concat_map (fun p -> List.concat_map by_goal (t.goal (view p))) timely
  @ List.map (fun p -> (p, Some Lost)) late

(* {1 Between two events} *)

let project u ~dimension = Union.map ~dimension (fun p -> Polyhedron.project p (Array.init dimension Fun.id)) u

(* Sets (y, d) as sets (y, ..., d), where y are [n] variables and d has the place [at] of [dimension]. *)
let moved u ~n ~dimension at =
  Union.map ~dimension (fun p -> Polyhedron.embed p ~dimension (Array.init (n + 1) (fun i -> if i < n then i else at))) u

let restrict u constraints =
  Union.map ~dimension:(Union.dimension u) (fun p -> Polyhedron.add_all p constraints) u

let variable = Linear.variable

(* Of (y, d) those that no (y, d') of another set with d' < d comes before. *)
let not_after ~n bad states =
  if Union.is_empty bad || Union.is_empty states then states
  else
    let dimension = n + 2 in
    let earlier = Constraint.less (variable dimension (n + 1)) (variable dimension n) in
    let any_later = Union.of_polyhedron (Polyhedron.add (Polyhedron.universe dimension) earlier) in
    let before = Union.inter any_later (moved bad ~n ~dimension (n + 1)) in
    Union.difference states (project before ~dimension:(n + 1))

(* The states (y, d) of a trajectory at which the goal comes first, at which something is not known, and at which the
   claim fails. *)
type met_on_the_way = { won : Union.t; open_ : Union.t; lost : Union.t }

let on_the_way t (z : Zone.t) =
  let n = Zone.dimension z - 1 in
  let view = { Atoms.zone = z; passing = true; quiescent = [] } in
  let of_truth truth test = List.filter_map (fun (p, x) -> if test x then Some p else None) truth in
  let set pieces = Union.of_polyhedra (n + 1) pieces in
  let goal = t.goal view and claim = t.claim view in
  let is_true = Truth.equal True and is_false = Truth.equal False in
  let is_open = function Truth.Undecided reason -> ignore (undecided t reason); true | True | False -> false in
  let in_window = List.concat_map (fun p -> fst (in_time t z p)) in
  let lost = set (of_truth claim is_false) in
  let open_claim = set (of_truth claim is_open) and open_goal = set (in_window (of_truth goal is_open)) in
  let bad = Union.union lost open_claim in
  { won = not_after ~n bad (set (in_window (of_truth goal is_true))); open_ = Union.union open_claim open_goal; lost }

(* A region by what is first met on the way; the sets are over its variables. *)
let divided region { won; open_; lost } =
  let take (rest, found) (set, tree) =
    let inside = Union.disjoint (Union.inter rest set) in
    (Union.difference rest inside, List.map (fun p -> (p, Some tree)) (Union.pieces inside) @ found)
  in
  let rest, found = List.fold_left take (Union.of_polyhedron region, []) [ (won, Won); (open_, Open); (lost, Lost) ] in
  List.map (fun p -> (p, None)) (Union.pieces (Union.disjoint rest)) @ List.rev found

let is_steady (p : Property.prop) = Formula.steady ~rigid:false p && not (Formula.has_events (State p))

(* Nothing that counts can be met on the way: it was so when it began. *)
let nothing_on_the_way t =
  is_steady t.question.claim && is_steady t.question.goal && Rat.sign t.question.bound.low = 0

let along t (z : Zone.t) (cell : Passing.due First.cell) =
  if nothing_on_the_way t then [ (cell.region, None) ]
  else
    let project u = project u ~dimension:(Zone.dimension z) in
    let w = on_the_way t (Passing.trajectory t.context z cell) in
    divided cell.region { won = project w.won; open_ = project w.open_; lost = project w.lost }

(* Where time stops for a split: what was met until then, over one more variable. *)
let along_until_stop t (z : Zone.t) (cell : Passing.due First.cell) (halted : Zone.t) =
  if nothing_on_the_way t then [ (halted.set, None) ]
  else
    let n = Zone.dimension z in
    let w = on_the_way t (Passing.trajectory t.context z cell) in
    let dimension = n + 2 in
    let no_later = Constraint.at_most (variable dimension (n + 1)) (variable dimension n) in
    let until u = project (restrict (moved u ~n ~dimension (n + 1)) [ no_later ]) ~dimension:(n + 1) in
    divided halted.set { won = until w.won; open_ = until w.open_; lost = until w.lost }

(* {1 Next steps} *)

let cells = function [ (_, tree) ] -> tree | all -> Cells all

let free t = function
  | [] -> Lost
  | [ (_, tree) ] -> tree
  | options ->
    t.chain <- false;
    Free options

(* The zones of one transition, to the next layer. *)
let go t next (zones : Zone.t list) =
  t.transitions <- t.transitions + 1;
  let one (z : Zone.t) = (z.Zone.set, later next z) in
  cells (List.map one (List.concat_map (Chance_steps.settled t.context) zones))

(* Each target of an event is one way, for the states of its set. *)
let events_of t next all = List.map (fun (h : Happening.t) -> (h.target.Zone.set, go t next [ h.target ])) all

let pass t next z (cell : Passing.due First.cell) =
  let on (region, met) =
    match (met, cell.time) with
    | Some tree, _ -> (region, tree)
    | None, None -> (region, Lost)
    | None, Some _ -> (region, go t next (Passing.until t.context z { cell with region }))
  in
  cells (List.map on (along t z cell))

let stop t next z (cell : Passing.due First.cell) =
  let halted = Passing.within t.context z cell in
  let splits set =
    let halted = { halted with set } in
    let of_region region =
      let happens = Happening.all t.context ~events:t.events halted region in
      match events_of t next happens.weak with [] -> [] | options -> [ (region, free t options) ]
    in
    List.concat_map of_region (Instant.cells t.context halted)
  in
  let on (region, met) = match met with Some tree -> [ (region, tree) ] | None -> splits region in
  t.chain <- false;
  List.map (fun (set, tree) -> Stopping (set, tree)) (List.concat_map on (along_until_stop t z cell halted))

let by_itself t next (z : Zone.t) =
  let c = t.context in
  let may_split = Zone_time.splits_at_any_time (Scc_semantics.Semantics.model c.semantics) z in
  let of_region region =
    let happens = Happening.all c ~events:t.events z region in
    let passes = not (Scc_semantics.Network.is_urgent happens) in
    let weak = if passes && may_split then [] else happens.weak in
    let events = events_of t next (List.concat_map List.rev [ happens.urgent; weak; happens.collisions ]) in
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
    match steps with
    | Drawn ways -> (region, Drawn (List.map (fun (chance, zones) -> (chance, go t next zones)) ways))
    | Chosen ways -> (region, free t (List.map (fun zones -> (region, go t next zones)) ways))
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
  let on (region, known) =
    match known with
    | Some tree -> [ (region, tree) ]
    | None ->
      let timely, late = not_after_time limits.horizon z region in
      List.map further timely @ List.map beyond late
  in
  cells (List.concat_map on (judged t z))

let rec explore_from t limits ~depth layer =
  match List.rev layer.nodes with
  | [] -> ()
  | nodes ->
    t.layers <- layer :: t.layers;
    let next = new_layer () in
    let of_node node =
      let of_set set = (set, expand t limits next ~depth { node.zone with Zone.set }) in
      limits.progress ~zones:t.size ~waiting:(List.length next.nodes) ~depth;
      node.trees <- List.map of_set node.sets
    in
    List.iter of_node nodes;
    explore_from t limits ~depth:(depth + 1) next

let explore context (question : question) limits zones =
  let formulas = [ Property.State question.claim; State question.goal ] in
  let events = Scc_data.Lists.distinct Formula.equal_event (List.concat_map Formula.events formulas) in
  let events = Array.of_list events in
  let atoms = Atoms.context context ~events in
  let t =
    {
      context; events; question;
      goal = Atoms.truth atoms question.goal;
      claim = Atoms.truth atoms question.claim;
      root = Lost; layers = []; reasons = []; size = 0; transitions = 0; chain = true;
      met = { too_late = false; too_deep = false; too_many = false; stopped = false };
    }
  in
  let first = new_layer () in
  let start (z : Zone.t) = (z.set, later first z) in
  t.root <- cells (List.map start (List.concat_map (Chance_steps.settled context) zones));
  explore_from t limits ~depth:0 first;
  t

let met t = t.met
let reasons t = List.sort String.compare t.reasons
let size t = t.size
let transitions t = t.transitions
let depth t = List.length t.layers
let is_chain t = t.chain

(* {1 Values} *)

type mode = { choice : [ `Least | `Greatest ]; chance : [ `Mean | `Least | `Greatest ] }

let known q : Piecewise.value = { least = q; most = q }

(* What an inclusion already says need not be tested again. *)
let new_constraints ~within set =
  let known = Polyhedron.constraints within in
  List.filter (fun c -> not (List.exists (Constraint.equal c) known)) (Polyhedron.constraints set)

(* The least or greatest of all values that a function over one more variable has on a set. As it has finitely many
   values, one of them is attained. *)
let over_last space choice set f =
  let n = Polyhedron.dimension set - 1 in
  let pieces = List.filter_map (fun (p, v) -> Option.map (fun v -> (p, v)) v) (Piecewise.pieces set f) in
  let by_end (end_ : Piecewise.value -> Rat.t) =
    let compare (_, v) (_, w) = Rat.compare (end_ v) (end_ w) in
    let sorted = List.stable_sort compare pieces in
    let best_first = match choice with `Least -> sorted | `Greatest -> List.rev sorted in
    let add found (p, v) =
      let there = Polyhedron.constraints (Polyhedron.project p (Array.init n Fun.id)) in
      Piecewise.first space found (Piecewise.within space there (Piecewise.constant space (known (end_ v))))
    in
    List.fold_left add (Piecewise.nowhere space) best_first
  in
  Piecewise.ends space (by_end (fun v -> v.least)) (by_end (fun v -> v.most))

let rec of_tree space mode ~within tree =
  let of_ = of_tree space mode in
  let constant least most = Piecewise.constant space { least; most } in
  let better side = match side with `Least -> Piecewise.least space | `Greatest -> Piecewise.greatest space in
  match tree with
  | Won -> constant Rat.one Rat.one
  | Lost -> constant Rat.zero Rat.zero
  | Open -> constant Rat.zero Rat.one
  | Cells all -> of_cells space mode ~within all
  | Drawn ways -> (
      let ways = List.map (fun (chance, tree) -> (chance, of_ ~within tree)) ways in
      match mode.chance with
      | `Mean -> Piecewise.sum space ways
      | (`Least | `Greatest) as side ->
        List.fold_left (fun best (_, f) -> better side best f) (Piecewise.nowhere space) ways)
  | Free options ->
    let option best (set, tree) =
      let f = Piecewise.within space (new_constraints ~within set) (of_ ~within:set tree) in
      better mode.choice best f
    in
    List.fold_left option (Piecewise.nowhere space) options
  | Stopping (set, tree) -> over_last space mode.choice set (of_ ~within:set tree)
  | Later (node, set) ->
    let holds (s, _) = s == set || Polyhedron.included set s in
    (match List.find_opt holds node.values with
     | Some (_, f) -> f
     | None -> Scc_base.Bug.fail __POS__ "states that were not explored")

(* The last one needs no test. *)
and of_cells space mode ~within = function
  | [] -> Piecewise.nowhere space
  | [ (set, tree) ] -> of_tree space mode ~within:set tree
  | (set, tree) :: rest ->
    let here = Piecewise.within space (new_constraints ~within set) (of_tree space mode ~within:set tree) in
    Piecewise.first space here (of_cells space mode ~within rest)

let solve t mode space =
  let of_node node =
    node.values <- List.map (fun (set, tree) -> (set, of_tree space mode ~within:set tree)) node.trees
  in
  List.iter (fun layer -> List.iter of_node layer.nodes) t.layers;
  let root = of_tree space mode ~within:(Polyhedron.universe (Piecewise.dimension space)) t.root in
  List.iter (fun layer -> List.iter (fun node -> node.values <- []) layer.nodes) t.layers;
  root
