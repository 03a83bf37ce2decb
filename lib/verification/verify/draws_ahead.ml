open Scc_calculus
open Scc_semantics
open Scc_graph_search
open Scc_state_space
module Graph = State_graph

(* A quotient makes one state of up to 48 that are congruent, the rotations and reflections of a cube. *)
let bits_of_isometries = 6

(* So many states show whether states are found again, and whether time has passed. *)
let enough = 1024

(* The greatest k for which 2^k is no more than n. *)
let bits n =
  let rec count found n = if n <= 1 then found else count (found + 1) (n / 2) in
  count 0 n

let sum = List.fold_left ( + ) 0

(* How many bodies draw, and a number k: at least 2^k states are found breadth first before the first one in which
   none of them waits any more. One draw is a step as long as the outcomes of those left are too many to be joined.
   Up to then there are as many states as outcomes of those that have drawn. The bits of a product are at least the
   sum of the bits of its factors. *)
let due semantics state =
  let outcomes p = match Steer.chances semantics state p with Ok all -> List.length all | Error _ -> 1 in
  let drawers = if Lots.pending state then [] else Steer.drawers semantics state in
  let all = List.sort Int.compare (List.map (fun p -> bits (outcomes p)) drawers) in
  let unjoined = sum all - bits Joint_draws.most - 1 in
  let walkers_left = List.filteri (fun i _ -> i < List.length all - Walk_draws.most_walkers) all in
  let walks = Model.stops_walkers (Semantics.model semantics) in
  let before = if walks then Int.min unjoined (sum walkers_left) else unjoined in
  (List.length drawers, before - bits_of_isometries)

let exceed states bits = bits >= Sys.int_size - 2 || (bits > 0 && states < 1 lsl bits)

let find (options : Setup.t) context checks (limits : Limits.t) =
  let unseen = checks <> [] && List.for_all Between_draws.unseen checks in
  let plain = Option.is_none options.observe && options.order = By_steps && Option.is_none limits.depth in
  let semantics = Network_lts.semantics context in
  match limits.states with
  | Some states when unseen && plain && Option.is_none (Semantics.model semantics).rigid ->
    let bodies, bits = due semantics (Network_lts.start context) in
    if exceed states bits then Some bodies else None
  | Some _ | None -> None

let few (limits : Limits.t) = { limits with states = Option.map (Int.min enough) limits.states }

let confirmed graph =
  let all_draw = Scc_exact.Rat.equal (Graph.arrival graph 0) (Graph.greatest_arrival graph) in
  Graph.left_for graph States = 0 || (all_draw && Graph.transitions graph <= 2 * Graph.size graph)
