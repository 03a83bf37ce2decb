open Scc_calculus
open Scc_graph_search
open Scc_state_space

type t = {
  bounds : Bounds.t;
  reductions : Reduction.kind list;
  compact : int option;
  order : State_graph.order;
  surroundings : Limits.surroundings;
  observe : (State.t -> unit) option;
  prove : bool;
  contrast : bool;
  curve : string option;
  parameter : Open_number.t option;
  expanding : about:string -> State_graph.expanding;
  compacting : about:string -> State_fingerprints.expanding;
}

let default =
  {
    bounds = Bounds.default;
    reductions = Reduction.all;
    compact = None;
    order = By_steps;
    surroundings = Limits.quiet;
    observe = None;
    prove = false;
    contrast = false;
    curve = None;
    parameter = None;
    expanding = (fun ~about:_ -> State_graph.here);
    compacting = (fun ~about:_ -> State_fingerprints.here);
  }

type share = { mine : int; all : int }

let shares ~size ~after list =
  let add x (all, found) =
    let mine = size x in
    (all + mine, (x, { mine; all = all + mine }) :: found)
  in
  snd (List.fold_right add list (after, []))

let share t { mine; all } =
  if mine <= 0 || mine >= all then t
  else { t with surroundings = t.surroundings.share ~mine ~all; bounds = { t.bounds with shared = true } }
