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

let in_rounds t ~size ~cut run list =
  let is_over () = Option.is_some (t.surroundings.stop ()) in
  (* The last one of a round has all that is left, and is done: so rounds end. *)
  let rec round done_ list =
    let once ((i, x), s) = ((i, x), s.mine < s.all, run (share t s) x) in
    let found = List.map once (shares ~size:(fun (_, x) -> size x) ~after:0 list) in
    let again, kept = List.partition (fun (_, shared, y) -> shared && cut y) found in
    let numbered = List.map (fun ((i, _), _, y) -> (i, y)) in
    if List.length again = 0 || is_over () then numbered found @ done_
    else round (numbered kept @ done_) (List.map (fun (x, _, _) -> x) again)
  in
  round [] (List.mapi (fun i x -> (i, x)) list)
  |> List.sort (fun (i, _) (j, _) -> Int.compare i j)
  |> List.map snd
