open Scc_data
open Scc_exact
open Scc_chance
open Decisions

(* {1 The choices of a node} *)

(* Where a branch leads: a node, or one of these, or the end with a number. *)
let at_goal = -1
let at_fail = -2
let at_end k = -3 - k
let end_number target = -3 - target

(* A branch leads to a node after one of the delays, numbered from 1 on, or at once, which is delay 0. *)
type choice = { weights : Arithmetic.weights; target : int array; delay : int array }

(* As long as the whole flow of a node is in the window, or all of it before, its choices do not depend on the
   time. *)
type part = Inside | Before | Cut

let endless = -1
let not_looked_at = -2

module Times = Map.Make (Rat)
module Rewards = Hashtbl.Make (Rat)

type layer = {
  time : Rat.t;
  mutable entered : Int_array.buffer;  (** nodes, as they are found; each may come several times *)
  mutable nodes : Int_array.t;  (** later: their ranks, each once, increasing *)
  parts : part Growable.t;  (** for each delay, from 0 on: of the flows that last so long *)
  later : layer option Growable.t;  (** for each delay: the layer that is so much later, once it was needed *)
  mutable index : int;  (** among all layers in the order of time *)
  mutable first : int;  (** the index of the first layer that leads here, or its own *)
}

type t = {
  graph : Timed_graph.t;
  side : Timed_formula.side;
  places : place -> branch list list;  (** the choices of a place *)
  window : window;
  starts : next list;
  earning : bool;  (** an end counts by the reward of its branch *)
  numbers : int Rewards.t;  (** of these rewards *)
  rewards : Rat.t Growable.t;  (** by these numbers *)
  delays : Rat.t Growable.t;
  lasts : Int_array.t;  (** for each node: the delay of its flow, [endless] or [not_looked_at] *)
  inside : choice array option array;  (** for each node, as far as it was needed *)
  before : choice array option array;
  mutable free : bool;  (** some place has several choices *)
  mutable base : Z.t;  (** a common multiple of all sums of weights *)
  mutable pending : layer Times.t;
  mutable layers : layer array;
  mutable rank : Int_array.t;  (** of each node: edges lead to smaller ranks; -1 for nodes that are not reached *)
  mutable node_of : Int_array.t;  (** of each rank *)
}

let delay_number t d =
  let rec find k =
    if k > Growable.length t.delays then begin
      Growable.push t.delays d;
      k
    end
    else if Rat.equal (Growable.get t.delays (k - 1)) d then k
    else find (k + 1)
  in
  if Rat.sign d = 0 then 0 else find 1

let end_of t reward =
  match Rewards.find_opt t.numbers reward with
  | Some k -> k
  | None ->
    let k = Growable.length t.rewards in
    Rewards.add t.numbers reward k;
    Growable.push t.rewards reward;
    k

let choice t elapsed branches =
  let branches = Array.of_list branches in
  let where b =
    match b.next with
    | Goal -> ((if t.earning then at_end (end_of t b.reward) else at_goal), 0)
    | Fail -> (at_fail, 0)
    | Go { node; elapsed = Some later } -> (node, delay_number t (Rat.sub later elapsed))
    | Go { elapsed = None; _ } -> Scc_base.Bug.fail __POS__ "a place without a time in a window that ends"
  in
  let weights = Arithmetic.weights (Array.map (fun b -> b.probability) branches) in
  t.base <- Z.lcm t.base weights.sum;
  let leads = Array.map where branches in
  { weights; target = Array.map fst leads; delay = Array.map snd leads }

let part t time d =
  let over = Rat.add time d in
  if Algebraic.compare_rat t.window.low over > 0 then Before
  else if Algebraic.compare_rat t.window.low time > 0 || reaches_beyond t.window (Algebraic.of_rat over) then Cut
  else Inside

let delay_of t s =
  let known = Int_array.get t.lasts s in
  if known <> not_looked_at then known
  else
    let delay =
      match Timed_graph.flow t.graph s with
      | No_flow -> 0
      | Lasts (d, _) -> delay_number t d
      | Forever -> endless
    in
    Int_array.set t.lasts s delay;
    delay

(* Parts are the same for all nodes of a layer whose flows last equally long. *)
let rec part_of t layer delay =
  if delay = endless then Cut
  else if Growable.length layer.parts <= delay then begin
    let k = Growable.length layer.parts in
    let d = if k = 0 then Rat.zero else Growable.get t.delays (k - 1) in
    Growable.push layer.parts (part t layer.time d);
    part_of t layer delay
  end
  else Growable.get layer.parts delay

let choices_of t layer s =
  let compute () =
    let choices = t.places { node = s; elapsed = Some layer.time } in
    if List.compare_length_with choices 1 > 0 then t.free <- true;
    Array.of_list (List.map (choice t layer.time) choices)
  in
  let cached table =
    match table.(s) with
    | Some choices -> choices
    | None ->
      let choices = compute () in
      table.(s) <- Some choices;
      choices
  in
  match part_of t layer (delay_of t s) with
  | Inside -> cached t.inside
  | Before -> cached t.before
  | Cut -> compute ()

(* {1 Forwards: the places of each layer} *)

let layer_at t time =
  match Times.find_opt time t.pending with
  | Some layer -> layer
  | None ->
    let layer =
      {
        time;
        entered = Int_array.buffer ();
        nodes = Int_array.make 0 0;
        parts = Growable.create ();
        later = Growable.create ();
        index = max_int;
        first = max_int;
      }
    in
    t.pending <- Times.add time layer t.pending;
    layer

let rec later t layer delay =
  if delay = 0 then layer
  else if Growable.length layer.later < delay then begin
    Growable.push layer.later None;
    later t layer delay
  end
  else
    match Growable.get layer.later (delay - 1) with
    | Some found -> found
    | None ->
      let found = layer_at t (Rat.add layer.time (Growable.get t.delays (delay - 1))) in
      Growable.set layer.later (delay - 1) (Some found);
      found

let enter t next =
  match next with
  | Goal | Fail | Go { elapsed = None; _ } -> ()
  | Go { node; elapsed = Some time } -> Int_array.push (layer_at t time).entered node

(* [seen.(s)] is the last layer in which node [s] was looked at. *)
let look t seen layer =
  let found = Int_array.buffer () in
  let follow { target; delay; _ } =
    Array.iteri
      (fun i s ->
         if s >= 0 then begin
           let next = later t layer delay.(i) in
           next.first <- Int.min next.first layer.index;
           Int_array.push next.entered s
         end)
      target
  in
  let rec go i =
    if i < Int_array.size layer.entered then begin
      let s = Int_array.nth layer.entered i in
      if not (Int.equal (Int_array.get seen s) layer.index) then begin
        Int_array.set seen s layer.index;
        Int_array.push found s;
        Array.iter follow (choices_of t layer s)
      end;
      go (i + 1)
    end
  in
  go 0;
  layer.nodes <- Int_array.contents found;
  layer.entered <- Int_array.buffer ()

exception Too_many of Rat.t

let too_many ~most ~over time =
  Printf.sprintf
    "up to time %s there are more than %d instants at which something happens, of which time %s is one; ask for \
     an earlier time"
    (Rat.to_string time) most (Rat.to_string over)

let forwards t ~most seen =
  List.iter (enter t) t.starts;
  let rec go index done_ =
    match Times.min_binding_opt t.pending with
    | None -> Array.of_list (List.rev done_)
    | Some (time, layer) ->
      (match done_ with
       | last :: _ when index >= most -> raise (Too_many last.time)
       | _ -> ());
      layer.index <- index;
      look t seen layer;
      layer.first <- Int.min layer.first index;
      t.pending <- Times.remove time t.pending;
      go (index + 1) (layer :: done_)
  in
  t.layers <- go 0 []

(* {1 The order within a layer} *)

(* Ranks such that edges lead to smaller ones; [None] if there are none. Every node has the edges that it has at
   all times, as those that a window excludes do no harm. *)
let rank t seen =
  let size = t.graph.size in
  let inside s = Int_array.get seen s >= 0 in
  let loops = ref false in
  let successors s =
    let edges = Timed_graph.edges t.graph s in
    if Array.exists (Int.equal s) edges then loops := true;
    edges
  in
  let components = Strong_components.compute ~size ~inside ~successors in
  let reached = ref 0 in
  for s = 0 to size - 1 do
    if inside s then incr reached
  done;
  if !loops || Strong_components.count components < !reached then None
  else begin
    let node_of = Int_array.make !reached 0 in
    Strong_components.iter components (fun rank s -> Int_array.set node_of rank s);
    Some (Strong_components.numbers components, node_of)
  end

(* [marks] has a byte for each rank, 0 before and after. Many ranks are marked and read in order; few are
   sorted. *)
let sort t marks nodes =
  let n = Int_array.length nodes in
  let rank i = Int_array.get t.rank (Int_array.get nodes i) in
  if n < Bytes.length marks / 16 then begin
    let ranks = Array.init n rank in
    Array.sort Int.compare ranks;
    Array.iteri (Int_array.set nodes) ranks
  end
  else begin
    for i = 0 to n - 1 do
      Bytes.set marks (rank i) '\001'
    done;
    let next = ref 0 in
    for r = 0 to Bytes.length marks - 1 do
      if not (Char.equal (Bytes.get marks r) '\000') then begin
        Int_array.set nodes !next r;
        incr next
      end
    done;
    Bytes.fill marks 0 (Bytes.length marks) '\000'
  end

let make graph side ~earning ~choices ~most window starts =
  if is_open window then None
  else
    let size = graph.Timed_graph.size in
    let t =
      {
        graph;
        side;
        places = choices;
        window;
        starts;
        earning;
        numbers = Rewards.create 16;
        rewards = Growable.create ();
        delays = Growable.create ();
        lasts = Int_array.make size not_looked_at;
        inside = Array.make size None;
        before = Array.make size None;
        free = false;
        base = Z.one;
        pending = Times.empty;
        layers = [||];
        rank = Int_array.make 0 0;
        node_of = Int_array.make 0 0;
      }
    in
    let seen = Int_array.make size (-1) in
    forwards t ~most seen;
    match rank t seen with
    | None -> None
    | Some (rank, node_of) ->
      t.rank <- rank;
      t.node_of <- node_of;
      let marks = Bytes.make (Int_array.length node_of) '\000' in
      Array.iter (fun layer -> sort t marks layer.nodes) t.layers;
      Some t

let until ?(most = max_int) (q : question) window starts =
  make q.graph q.side ~most ~earning:false ~choices:(Decisions.choices q window) window starts

let means ?(most = max_int) graph side ~choices time starts =
  let window = { low = Algebraic.of_rat time; high = Some (Algebraic.of_rat time) } in
  make graph side ~most ~earning:true ~choices window starts

(* {1 Places} *)

(* The index of a rank in a layer. *)
let index layer rank =
  let rec find low high =
    let middle = (low + high) / 2 in
    let here = Int_array.unsafe_get layer.nodes middle in
    if Int.equal here rank then middle
    else if here < rank then find (middle + 1) high
    else find low (middle - 1)
  in
  find 0 (Int_array.length layer.nodes - 1)

let rank_of t s = if s < 0 then s else Int_array.get t.rank s

let layer_of t time =
  let rec find low high =
    let middle = (low + high) / 2 in
    let c = Rat.compare t.layers.(middle).time time in
    if c = 0 then t.layers.(middle) else if c < 0 then find (middle + 1) high else find low (middle - 1)
  in
  find 0 (Array.length t.layers - 1)

(* {1 Arrivals} *)

module Moments = Set.Make (struct
    type t = Timeline.moment

    let compare = Timeline.compare_moment
  end)

let arrivals q w t =
  let known = Hashtbl.create 64 in
  let of_node layer rank =
    let s = Int_array.get t.node_of rank in
    let compute () = meetings q w { node = s; elapsed = Some layer.time } in
    match part_of t layer (delay_of t s) with
    | Inside -> (
        match Hashtbl.find_opt known s with
        | Some found -> found
        | None ->
          let found = compute () in
          Hashtbl.add known s found;
          found)
    | Before | Cut -> compute ()
  in
  let add all layer =
    let here = ref Moments.empty in
    for i = 0 to Int_array.length layer.nodes - 1 do
      List.iter (fun m -> here := Moments.add m !here) (of_node layer (Int_array.get layer.nodes i))
    done;
    let later ({ offset; attained } : Timeline.moment) =
      { Timeline.offset = Algebraic.add_rat layer.time offset; attained }
    in
    Moments.fold (fun m -> Moments.add (later m)) !here all
  in
  Moments.elements (Array.fold_left add Moments.empty t.layers)

(* {1 What others read} *)

let side t = t.side
let choices t = t.places
let rewards t = Array.init (Growable.length t.rewards) (Growable.get t.rewards)
let starts t = t.starts
let is_free t = t.free
let base t = t.base
let all t = t.layers
let time (layer : layer) = layer.time
let number (layer : layer) = layer.index
let first_source layer = layer.first
let ranks layer = layer.nodes
let node_of t rank = Int_array.get t.node_of rank
let count t = Int_array.length t.node_of
