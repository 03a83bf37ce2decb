open Scc_exact
open Scc_polyhedra
open Scc_semantics
open Scc_state_sets

type step = Happens of Transition.label | Passes of Rat.t | Passes_some of Rat.t
type t = { values : Rat.t array; steps : step list; offset : Rat.t }

(* The way so far: over the variables of the root, and the times that were waited for splits, in order. *)
type way = {
  set : Polyhedron.t;
  here : Linear.t array;  (** the variables of the node *)
  taken : (Zone_steps.step * Linear.t option) list;  (** the last first, with the time that passes *)
  length : int;  (** of what is taken *)
  names : int array;  (** for each leaf of the node, which one of the root it is (rule Symmetry) *)
}

let extended dimension f =
  let n = Linear.dimension f in
  if n = dimension then f else Linear.compose f ~dimension (Array.init n (Linear.variable dimension))

(* The way, over as many variables more, the last ones. *)
let extend way more =
  if more = 0 then way
  else
    let n = Polyhedron.dimension way.set in
    let dimension = n + more in
    let set = Polyhedron.embed way.set ~dimension (Array.init n Fun.id) in
    { way with set; here = Array.map (extended dimension) way.here }

(* Variables of a polyhedron over those of the node, and perhaps one more, as forms. *)
let enter way guard =
  let more = Polyhedron.dimension guard - Array.length way.here in
  let way = extend way more in
  let dimension = Polyhedron.dimension way.set in
  let added = Array.init more (fun i -> Linear.variable dimension (dimension - more + i)) in
  let forms = Array.append way.here added in
  let set = Polyhedron.inter way.set (Polyhedron.preimage guard ~dimension forms) in
  ({ way with set }, forms)

let along way (edge : Zone_graph.edge) =
  let way, forms = enter way edge.guard in
  let dimension = Polyhedron.dimension way.set in
  let over f = Linear.compose f ~dimension forms in
  let time =
    match edge.step with
    | Happens _ -> None
    | Passes f -> Some (over f)
    | Passes_some -> Some forms.(Array.length forms - 1)
  in
  let step : Zone_steps.step =
    match edge.step with
    | Happens label -> Happens (Transition.renamed (fun leaf -> way.names.(leaf)) label)
    | (Passes _ | Passes_some) as step -> step
  in
  let names = Array.copy way.names in
  let rename image = Array.iteri (fun leaf other -> names.(other) <- way.names.(leaf)) image in
  Option.iter rename edge.renamed;
  let taken = (step, time) :: way.taken in
  { way with here = Array.map over edge.map; taken; length = way.length + 1; names }

(* Edges that lead to some states of a node, which are found backwards: from where an edge leads into them. *)
let rec to_root graph (node : Zone_graph.node) states edges =
  match node.parents with
  | [] -> (node, edges)
  | parents -> (
      let from (i, (edge : Zone_graph.edge)) =
        let parent = Zone_graph.node graph i in
        let dimension = Polyhedron.dimension edge.guard in
        let all = Polyhedron.inter edge.guard (Polyhedron.preimage states ~dimension edge.map) in
        if Polyhedron.is_empty all then None
        else Some (parent, Polyhedron.project all (Array.init (Zone.dimension parent.zone) Fun.id), edge)
      in
      match List.find_map from parents with
      | Some (parent, states, edge) -> to_root graph parent states (edge :: edges)
      | None -> Scc_base.Bug.fail __POS__ "states that no edge leads to")

let start (z : Zone.t) set =
  let here = Array.init (Zone.dimension z) (Linear.variable (Zone.dimension z)) in
  { set; here; taken = []; length = 0; names = Array.init (Array.length z.places) Fun.id }

let way_to graph (place : Search_sets.place) =
  let n = Zone.dimension place.node.zone in
  let root, edges = to_root graph place.node (Polyhedron.project place.states (Array.init n Fun.id)) [] in
  let z = root.zone in
  let way, forms = enter (List.fold_left along (start z z.set) edges) place.states in
  (z, way, forms)

(* The way with no wait for a split that need not be, the first ones first: the run is shorter then. *)
let sample way =
  let dimension = Polyhedron.dimension way.set in
  let no_wait set (step, time) =
    match ((step : Zone_steps.step), time) with
    | Passes_some, Some t ->
      let none = Constraint.equals (extended dimension t) (Linear.constant dimension Rat.zero) in
      let at_once = Polyhedron.add set none in
      if Polyhedron.is_empty at_once then set else at_once
    | (Happens _ | Passes _ | Passes_some), _ -> set
  in
  Polyhedron.interior_point (List.fold_left no_wait way.set (List.rev way.taken))

let at_point (root : Zone.t) way forms ~passing point =
  let value f = Linear.eval (extended (Array.length point) f) point in
  let waits = function Passes_some t -> Rat.sign t > 0 | Happens _ | Passes _ -> true in
  let step (step, time) =
    match ((step : Zone_steps.step), time) with
    | Happens label, _ -> Happens label
    | Passes _, Some t -> Passes (value t)
    | Passes_some, Some t -> Passes_some (value t)
    | (Passes _ | Passes_some), None -> Scc_base.Bug.fail __POS__ "time that passes is known"
  in
  {
    values = Array.map value root.parameters;
    steps = List.filter waits (List.rev_map step way.taken);
    offset = (if passing then value forms.(Array.length forms - 1) else Rat.zero);
  }

let run_within graph (place : Search_sets.place) values =
  let z = place.node.zone in
  let dimension = Polyhedron.dimension place.states in
  let here = Polyhedron.preimage values ~dimension (Array.map (extended dimension) z.parameters) in
  let place = { place with states = Polyhedron.inter place.states here } in
  if Polyhedron.is_empty place.states then None
  else
    let root, way, forms = way_to graph place in
    Option.map (at_point root way forms ~passing:place.passing) (sample way)

let run graph place =
  let root, way, forms = way_to graph place in
  match sample way with
  | Some point -> at_point root way forms ~passing:place.passing point
  | None -> Scc_base.Bug.fail __POS__ "a way to nowhere"
