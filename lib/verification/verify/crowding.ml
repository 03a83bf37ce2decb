open Scc_exact
open Scc_semantics
open Scc_state_space
module Graph = State_graph

type what = Events | Weak_splits | Draws
type t = { what : what; states : int; instants : int }

(* States found last. *)
let sample = 2048

(* Those among them whose transitions are looked at. *)
let looked_into = 128

module Instants = Map.Make (struct
    type t = Rat.t

    let compare = Rat.compare
  end)

let label context (e : Graph.edge) = Catalogue.single (Network_lts.catalogue context) e.label

(* In how many ways an event of each kind was one of several at a state. What is drawn is no choice. *)
let choices context graph states =
  let add (others, splits) i =
    let labels = List.filter_map (label context) (Array.to_list (Graph.edges graph i)) in
    let is_event : Transition.label -> bool = function
      | Time _ | Draw _ | Lot _ -> false
      | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ -> true
    in
    let events = List.filter is_event labels in
    let is_split : Transition.label -> bool = function
      | Weak_split _ -> true
      | Time _ | Bind _ | Close _ | Bounce _ | Absorb _ | Strong_split _ | Draw _ | Lot _ -> false
    in
    let weak = List.length (List.filter is_split events) in
    (* A weak split is a choice by itself: it can be put off. *)
    let other = List.length events - weak in
    ((others + if other > 1 then other else 0), splits + weak)
  in
  List.fold_left add (0, 0) states

(* Draws of one instant, at least, by which a state is one of many. *)
let many_draws = 3

(* How many draws in a row end at a state, up to [many_draws]. One transition may stand for several. *)
let rec draws context graph ~counted i =
  let of_edge (e : Graph.edge) =
    if e.target <> i then 0
    else
      match label context e with
      | Some (Draw _ | Lot _) -> 1
      | Some (Time _ | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _) -> 0
      | None -> Catalogue.transitions (Network_lts.catalogue context) e.label
  in
  match Graph.before graph i with
  | Some j when counted < many_draws -> (
      match Array.fold_left (fun most e -> Int.max most (of_edge e)) 0 (Graph.edges graph j) with
      | 0 -> counted
      | some -> draws context graph ~counted:(counted + some) j)
  | Some _ | None -> counted

let spread count among = List.init (Int.min count among) (fun k -> k * (among / Int.min count among))

(* The states found last are mostly not expanded: of those before them the transitions are known. *)
let find context graph =
  let n = Graph.size graph in
  let first = Int.max 0 (n - sample) in
  let states = n - first in
  let count found i =
    Instants.update (Graph.arrival graph i) (fun c -> Some (1 + Option.value c ~default:0)) found
  in
  let instants = Instants.cardinal (List.fold_left count Instants.empty (List.init states (fun i -> first + i))) in
  if states < 256 || states < 16 * instants then None
  else
    let drawn i = draws context graph ~counted:0 i >= many_draws in
    let last = List.map (fun k -> n - 1 - k) (spread looked_into states) in
    let expanded = List.filter (fun i -> Graph.status graph i = Expanded) in
    let before = expanded (List.map (fun k -> n - 1 - k) (spread sample n)) in
    let others, splits = choices context graph (List.filteri (fun k _ -> k < looked_into) before) in
    if 2 * List.length (List.filter drawn last) >= List.length last then Some { what = Draws; states; instants }
    else if others = 0 && splits = 0 then None
    else Some { what = (if splits > others then Weak_splits else Events); states; instants }
