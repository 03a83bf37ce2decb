open Scc_data
open Scc_ctl
open Scc_graph_search
open Scc_successors

type way = { sender : int; before : int; choice : int }
type hit = { id : int; goal : int; sure : bool }

type t = {
  filter : Filter.t;
  table : Tuples.t;
  before : Int_vector.t;
  choices : Int_vector.t;
  senders : Int_vector.t;
  instants : Int_vector.t;
  too_long : (int, unit) Hashtbl.t;
  turning : (int, unit) Hashtbl.t;  (** states to which cycles in which no time passes may come back *)
  searched : bool array;  (** of each goal *)
  mutable hits : hit list;
  mutable open_from : int;
  mutable in_rounds : bool;
  clock : Clock.t option;
}

let make ?clock filter =
  let width = Scc_state_space.Network_lts.width (Filter.context filter) in
  {
    filter; clock;
    table = Tuples.create ~width;
    before = Int_vector.create (); choices = Int_vector.create (); senders = Int_vector.create ();
    instants = Int_vector.create ();
    too_long = Hashtbl.create 16; turning = Hashtbl.create 16;
    searched = Array.map (fun _ -> true) (Filter.predicates filter);
    hits = [];
    open_from = 0;
    in_rounds = true;
  }

let filter p = p.filter
let clock p = p.clock
let table p = p.table
let size p = Tuples.size p.table
let instant p id = Int_vector.get p.instants id
let is_too_long p id = Hashtbl.length p.too_long > 0 && Hashtbl.mem p.too_long id
let found p goal = p.searched.(goal) <- false
let close p = p.open_from <- size p
let keep_first p =
  p.open_from <- max_int;
  p.in_rounds <- false

let hits p =
  let all = p.hits in
  p.hits <- [];
  all

let way p id =
  let get vector = Int_vector.get vector id in
  { sender = get p.senders; before = get p.before; choice = get p.choices }

let most_number = 1 lsl 30

let check_number n =
  if n >= most_number then Failure.lost "a limit of resources: a level, or an owner, of more than 2^30 states"

let note p id goal (truth : Truth.t) =
  match truth with
  | False -> ()
  | True -> if p.searched.(goal) then p.hits <- { id; goal; sure = true } :: p.hits
  | Undecided _ -> if p.searched.(goal) then p.hits <- { id; goal; sure = false } :: p.hits

(* A state has come that was not there. *)
let add p id target ~time ~instant ~sender ~before ~choice =
  Option.iter (fun c -> Clock.add c ~time { before; choice }) p.clock;
  check_number before;
  check_number id;
  Int_vector.push p.before before;
  Int_vector.push p.choices choice;
  Int_vector.push p.senders sender;
  Int_vector.push p.instants instant;
  let reached = Filter.reach p.filter target [||] in
  Array.iteri (note p id) reached.goals;
  if reached.too_long then Hashtbl.replace p.too_long id ()

let look_again p id =
  let near = Tuples.spread p.table in
  Tuples.load p.table near id;
  Array.iteri (note p id) (Filter.reach p.filter (Tuples.slots near) [||]).goals

let set_way p id ~instant ~sender ~before ~choice =
  Int_vector.set p.instants id instant;
  Int_vector.set p.before id before;
  Int_vector.set p.choices id choice;
  Int_vector.set p.senders id sender

let set_if_first p id ~instant ~sender ~before ~choice =
  let known = Int_vector.get p.before id in
  if before < known || (before = known && choice < Int_vector.get p.choices id) then
    set_way p id ~instant ~sender ~before ~choice

let turns_at p id = Hashtbl.replace p.turning id ()
let turning p = Hashtbl.fold (fun id () all -> id :: all) p.turning []

let again p id ~time ~instant ~sender ~before ~choice =
  match p.clock with
  | None ->
    if id >= p.open_from then set_if_first p id ~instant ~sender ~before ~choice
    else if instant > 0 && p.in_rounds then turns_at p id
  | Some clock -> (
      match Clock.again clock id ~time { before; choice } with
      | Nothing -> if instant > 0 && Clock.turn clock id <= before then turns_at p id
      | Same -> set_if_first p id ~instant ~sender ~before ~choice
      | Earlier -> set_way p id ~instant ~sender ~before ~choice)

let enter p ~near changes target ~time ~instant ~sender ~before ~choice =
  let known = size p in
  let id = Tuples.intern p.table ~near changes in
  if id = known then add p id target ~time ~instant ~sender ~before ~choice
  else again p id ~time ~instant ~sender ~before ~choice;
  id

let enter_prepared p n target ~time ~instant ~sender ~before ~choice =
  let known = size p in
  let id = Tuples.intern_prepared p.table n in
  if id = known then add p id target ~time ~instant ~sender ~before ~choice
  else again p id ~time ~instant ~sender ~before ~choice

let enter_initial p ~home =
  let initial = (Filter.initial p.filter).tuple in
  let all = Tuples.difference (Array.map (fun _ -> -1) initial) initial in
  let near = Tuples.spread p.table in
  ignore (enter p ~near all initial ~time:0 ~instant:0 ~sender:home ~before:0 ~choice:0)
