open Scc_calculus
open Scc_semantics
open Scc_state_space
module Graph = State_graph

type edge = { label : Transition.label; chance : Scc_exact.Rat.t option; target : int }

type t = {
  semantics : Semantics.t;
  size : int;
  state : int -> State.t;
  edges : int -> edge array;
  expanded : int -> bool;
  rests : int -> bool;
  split_step : Scc_exact.Rat.t option;
  stopped_by : Verdict.truncation list;
  faults : Scc_base.Diag.t list;
  dead_ends : Scc_base.Diag.t list;
}

type visitor = { found : State.t -> unit; expanded : State.t -> unit }

let told visitor context =
  let state tuple = Catalogue.decode (Network_lts.catalogue context) tuple in
  {
    Graph.blind with
    found = (fun _ _ tuple -> visitor.found (state tuple));
    opened = Some (fun _ _ tuple _ -> visitor.expanded (state tuple));
  }

let explore ?time_seen ?visitor options semantics ~initial =
  let visitor = Option.map told visitor in
  let context, graph, (stats : Stats.t) =
    Joint_check.explore ?time_seen ?visitor options semantics ~initial
  in
  let catalogue = Network_lts.catalogue context in
  let edge (e : Graph.edge) =
    { label = Catalogue.label_of catalogue e.label; chance = Catalogue.chance catalogue e.label; target = e.target }
  in
  let expanded i =
    match Graph.status graph i with Scc_graph_search.Explore.Expanded -> true | Queued | Unexpanded _ -> false
  in
  let state i = Catalogue.decode catalogue (Graph.tuple graph i) in
  {
    semantics;
    size = Graph.size graph;
    state;
    edges = (fun i -> Array.map edge (Graph.edges graph i));
    expanded;
    rests = (fun i -> expanded i && Network.quiescent semantics (state i));
    split_step = stats.split_step;
    stopped_by = stats.stopped_by;
    faults = stats.faults;
    dead_ends = stats.dead_ends;
  }

let model s = Semantics.model s.semantics
let complete s =
  let rec from i = i = s.size || (s.expanded i && from (i + 1)) in
  from 0

let sum s f =
  let rec from i n = if i = s.size then n else from (i + 1) (n + f i) in
  from 0 0

let unexpanded s = sum s (fun i -> if s.expanded i then 0 else 1)
let transitions s = sum s (fun i -> Array.length (s.edges i))
