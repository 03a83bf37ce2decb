open Scc_data
open Scc_exact

type flow = No_flow | Lasts of Rat.t * int array | Forever
type t = {
  size : int;
  known : int -> bool;
  edges : int -> int array;
  drawn : int -> Rat.t option array option;
  flow : int -> flow;
}

let edges g s = if g.known s then g.edges s else [||]
let flow g s = if g.known s then g.flow s else No_flow
let targets = function Lasts (_, targets) -> targets | No_flow | Forever -> [||]

let is_dead_end g s =
  g.known s
  && Array.length (g.edges s) = 0
  && match g.flow s with No_flow -> true | Lasts _ | Forever -> false

let extent : flow -> Timeline.extent = function
  | No_flow -> Instant
  | Lasts (d, _) -> Lasts d
  | Forever -> Forever

type move = Edge of int | Flow of int

let edge_choices g s =
  let alone k t = [ (k, t, Rat.one) ] in
  let targets = Array.to_list (edges g s) in
  match g.drawn s with
  | None -> List.mapi alone targets
  | Some chances ->
    let numbered = List.mapi (fun k t -> (k, t)) targets in
    let drawn (k, t) = Option.map (fun chance -> (k, t, chance)) chances.(k) in
    let others = List.filter (fun (k, _) -> Option.is_none chances.(k)) numbered in
    List.filter_map drawn numbered :: List.map (fun (k, t) -> alone k t) others

let is_chain g =
  let is_drawn chances = Array.for_all Option.is_some chances in
  let choices s =
    let timed = match g.flow s with No_flow -> 0 | Forever -> 1 | Lasts (_, targets) -> Array.length targets in
    match g.drawn s with
    | Some chances when is_drawn chances -> timed + 1
    | Some _ | None -> timed + Array.length (g.edges s)
  in
  let rec from s = s >= g.size || (((not (g.known s)) || choices s <= 1) && from (s + 1)) in
  from 0

let target g s = function Edge k -> (edges g s).(k) | Flow k -> (targets (flow g s)).(k)

let duration g s = function
  | Edge _ -> Rat.zero
  | Flow _ -> (
      match flow g s with
      | Lasts (d, _) -> d
      | No_flow | Forever -> Scc_base.Bug.fail __POS__ "a move at the end of a flow that has none")

(* The ways into node t are those in [source] from [first.(t)] up to [first.(t + 1)]: twice the node that they
   come from, and one more when they are timed. *)
type index = {
  graph : t;
  complete : bool;
  first : Int_array.t;
  source : Int_array.t;
}

let graph i = i.graph
let complete i = i.complete

let iter_sources i t f =
  for k = Int_array.get i.first t to Int_array.get i.first (t + 1) - 1 do
    let code = Int_array.get i.source k in
    f (code lsr 1) (code land 1 = 1)
  done

let iter_ways g s f =
  Array.iter (fun t -> f t (2 * s)) (edges g s);
  Array.iter (fun t -> f t ((2 * s) + 1)) (targets (flow g s))

let index g =
  (* Numbers are doubled in 32 bits with a sign. *)
  if g.size >= 1 lsl 30 then Scc_base.Bug.fail __POS__ "too many nodes";
  let first = Int_array.make (g.size + 1) 0 in
  let complete = ref true and ways = ref 0 in
  for s = 0 to g.size - 1 do
    if not (g.known s) then complete := false;
    iter_ways g s (fun t _ ->
        incr ways;
        Int_array.set first t (Int_array.get first t + 1))
  done;
  (* Each [first] becomes the end of its node, and goes down to the beginning while the ways are entered. *)
  let sum = ref 0 in
  for t = 0 to g.size do
    sum := !sum + Int_array.get first t;
    Int_array.set first t !sum
  done;
  let source = Int_array.make !ways 0 in
  for s = g.size - 1 downto 0 do
    iter_ways g s (fun t code ->
        let k = Int_array.get first t - 1 in
        Int_array.set first t k;
        Int_array.set source k code)
  done;
  { graph = g; complete = !complete; first; source }
