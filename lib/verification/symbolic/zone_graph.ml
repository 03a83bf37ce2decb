open Scc_exact
open Scc_polyhedra
open Scc_state_sets

type edge = {
  guard : Polyhedron.t;
  step : Zone_steps.step;
  target : int;
  map : Linear.t array;
  renamed : int array option;
}


type node = {
  number : int;
  mutable zone : Zone.t;
  depth : int;
  mutable parents : (int * edge) list;
  mutable edges : edge list;
  mutable cells : Passing.due First.cell list;
  mutable late : Polyhedron.t list;
  beyond : int option;
  mutable expanded : bool;
}

type later = Followed of int | Unexplored
type limits = { depth : int option; nodes : int option; horizon : Rat.t option; later : later }
type end_ = Closed | Decided | Bounded of { depth : bool; nodes : bool } | Stopped | Not_affine of string

type t = {
  nodes : node Scc_data.Growable.t;
  index : node Zone_index.t;
  waiting : node Queue.t;
  mutable roots : node list;
}

type visitor = {
  found : node -> unit;
  expanded : node -> unit;
  late : Zone.t -> unit;
  enough : t -> bool;
  stop : unit -> bool;
}

let size g = Scc_data.Growable.length g.nodes
let node g i = Scc_data.Growable.get g.nodes i
let roots g = List.rev g.roots

type exploration = {
  graph : t;
  context : Instant.context;
  limits : limits;
  visitor : visitor;
  displaced : bool;
  visible : (int -> bool) option;
  interchangeable : int list list;
}

let put e zone ~beyond parent =
  let g = e.graph in
  let depth = match parent with None -> 0 | Some (i, _) -> (node g i).depth + 1 in
  let parents = Option.to_list parent in
  let node =
    { number = size g; zone; depth; parents; edges = []; cells = []; late = []; beyond; expanded = false }
  in
  Scc_data.Growable.push g.nodes node;
  Zone_index.add g.index zone node;
  if Option.is_none beyond || e.limits.later <> Unexplored then Queue.add node g.waiting;
  e.visitor.found node;
  node

(* The parts of a zone up to the horizon, and after it. *)
let cut_at_horizon e (z : Zone.t) =
  match (e.limits.horizon, z.time) with
  | Some h, Some time ->
    let in_time = Constraint.at_most time (Linear.constant (Zone.dimension z) h) in
    if Polyhedron.implies z.set in_time then ([ z ], [])
    else
      let part c = { z with set = Polyhedron.add z.set c } in
      let some (z : Zone.t) = not (Polyhedron.is_empty z.set) in
      (List.filter some [ part in_time ], List.map part (Constraint.negation in_time))
  | None, _ | _, None -> ([ z ], [])

(* A node that has all of a zone, with its variables by those of the zone: one that is there, or a new one. *)
let node_of e zone ~beyond ~parent =
  let canonical, forms = Zone_form.canonical (if e.displaced then Zone_form.centred zone else zone) in
  let sample = lazy (Zone_form.sample canonical) in
  let holds n =
    if Option.equal Int.equal n.beyond beyond && Zone_form.has n.zone (Lazy.force sample) then
      Option.map (fun map -> (n, map)) (Zone_form.included canonical n.zone)
    else None
  in
  match Zone_index.last_around e.graph.index canonical holds with
  | Some (n, map) ->
    (n, Array.map (fun f -> Linear.compose f ~dimension:(Zone.dimension zone) forms) map)
  | None -> (
      let grown (n : node) =
        if n.expanded || n.parents = [] || not (Option.equal Int.equal n.beyond beyond) then None
        else Option.map (fun z -> (n, z)) (Zone_form.merged n.zone canonical)
      in
      match List.find_map grown (Zone_index.alike e.graph.index canonical) with
      | None -> (put e canonical ~beyond (parent (size e.graph) forms), forms)
      | Some (n, zone) ->
        n.zone <- zone;
        n.parents <- n.parents @ Option.to_list (parent n.number forms);
        (n, forms))

let link e (source : node) (step : Zone_steps.step) ~beyond (zone : Zone.t) =
  let renamed = Zone_symmetry.image ~classes:e.interchangeable zone in
  let edge n map = { guard = zone.set; step; target = n; map; renamed } in
  let zone = Option.fold ~none:zone ~some:(Zone_form.renamed zone) renamed in
  let n, map = node_of e zone ~beyond ~parent:(fun number map -> Some (source.number, edge number map)) in
  source.edges <- edge n.number map :: source.edges

(* After the horizon only so many events are followed, and the time that passes before them. *)
let add_edge e (source : node) (step : Zone_steps.step) (target : Zone.t) =
  let within, late = cut_at_horizon e target in
  List.iter (link e source step ~beyond:None) within;
  let so_far = Option.value source.beyond ~default:0 in
  let is_followed = match e.limits.later with Followed most -> so_far < most | Unexplored -> false in
  let linked events = List.iter (link e source step ~beyond:(Some events)) late in
  match step with
  | (Happens _ | Passes _ | Passes_some) when late = [] -> ()
  | Happens _ when is_followed -> linked (so_far + 1)
  | (Passes _ | Passes_some) when is_followed -> linked so_far
  | Happens _ | Passes _ | Passes_some -> (
      e.visitor.late target;
      match (step, e.limits.later) with
      | _, Unexplored -> linked so_far
      | Passes _, _ -> source.late <- List.map (fun (z : Zone.t) -> z.set) late @ source.late
      | (Happens _ | Passes_some), _ -> ())

let expand e ~events (source : node) =
  let { Zone_steps.cells; steps; postponed } =
    Zone_steps.all ?visible:e.visible e.context ~events source.zone
  in
  source.cells <- cells;
  let add = List.iter (fun (step, target) -> add_edge e source step target) in
  add steps;
  (* What is postponed happens after one of these steps, whichever state of the zone takes it. *)
  let is_ahead (edge : edge) = edge.target <> source.number && not (node e.graph edge.target).expanded in
  if not (List.for_all is_ahead source.edges) then add postponed;
  source.edges <- List.rev source.edges;
  source.expanded <- true;
  e.visitor.expanded source

let forget (n : node) =
  n.cells <- [];
  n.edges <- [];
  n.late <- [];
  n.expanded <- false

let always work =
  work ();
  true

let explore ?(displaced = false) ?visible ?(interchangeable = []) ?(attempt = always) context ~events ~limits
    ~visitor zones =
  let graph =
    { nodes = Scc_data.Growable.create (); index = Zone_index.create (); waiting = Queue.create (); roots = [] }
  in
  let e = { graph; context; limits; visitor; displaced; visible; interchangeable } in
  let root zone =
    let n, _ = node_of e zone ~beyond:None ~parent:(fun _ _ -> None) in
    graph.roots <- n :: graph.roots
  in
  List.iter root zones;
  let too_deep = ref false in
  let full () = match limits.nodes with None -> false | Some n -> size graph >= n in
  let is_too_deep (n : node) = match limits.depth with None -> false | Some d -> n.depth >= d in
  let rec go () =
    if visitor.enough graph then Decided
    else if visitor.stop () then Stopped
    else if full () && not (Queue.is_empty graph.waiting) then Bounded { depth = !too_deep; nodes = true }
    else
      match Queue.take_opt graph.waiting with
      | None -> if !too_deep then Bounded { depth = true; nodes = false } else Closed
      | Some n ->
        if is_too_deep n then begin
          too_deep := true;
          go ()
        end
        else (
          match attempt (fun () -> expand e ~events n) with
          | true -> go ()
          | false ->
            forget n;
            Stopped
          | exception Instant.Not_affine reason ->
            forget n;
            Not_affine reason)
  in
  let end_ = go () in
  (graph, end_)
