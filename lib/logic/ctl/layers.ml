open Scc_data
open Scc_exact
open Scc_chance
open Decisions

(* {1 The choices of a node} *)

(* Where a branch leads: a node, or one of these. *)
let at_goal = -1
let at_fail = -2

(* A branch leads to a node after one of the delays, numbered from 1 on, or at once, which is delay 0. *)
type choice = { weights : Arithmetic.weights; target : int array; delay : int array }

(* As long as the whole flow of a node is in the window, or all of it before, its choices do not depend on the
   time. *)
type part = Inside | Before | Cut

let endless = -1
let not_looked_at = -2

module Times = Map.Make (Rat)

type layer = {
  time : Rat.t;
  mutable entered : Int_array.buffer;  (** nodes, as they are found; each may come several times *)
  mutable nodes : Int_array.t;  (** later: their ranks, each once, increasing *)
  parts : part Growable.t;  (** for each delay, from 0 on: of the flows that last so long, as far as it was needed *)
  later : layer option Growable.t;  (** for each delay: the layer that is so much later, as far as it was needed *)
  mutable index : int;  (** among all layers in the order of time *)
  mutable first : int;  (** the index of the first layer that leads here, or its own *)
}

type t = {
  question : question;
  window : window;
  starts : next list;
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

let choice t elapsed branches =
  let branches = Array.of_list branches in
  let where b =
    match b.next with
    | Goal -> (at_goal, 0)
    | Fail -> (at_fail, 0)
    | Go { node; elapsed = Some later } -> (node, delay_number t (Rat.sub later elapsed))
    | Go { elapsed = None; _ } -> Scc_base.Bug.fail __POS__ "a place without a time in a window that ends"
  in
  let weights = Arithmetic.weights (Array.map (fun b -> b.probability) branches) in
  t.base <- Z.lcm t.base weights.sum;
  { weights; target = Array.map (fun b -> fst (where b)) branches; delay = Array.map (fun b -> snd (where b)) branches }

let part t time d =
  let over = Rat.add time d in
  if Algebraic.compare_rat t.window.low over > 0 then Before
  else if Algebraic.compare_rat t.window.low time <= 0 && not (reaches_beyond t.window (Algebraic.of_rat over)) then
    Inside
  else Cut

let delay_of t s =
  let known = Int_array.get t.lasts s in
  if known <> not_looked_at then known
  else
    let delay =
      match Timed_graph.flow t.question.graph s with
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
    let choices = Decisions.choices t.question t.window { node = s; elapsed = Some layer.time } in
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
  match part_of t layer (delay_of t s) with Inside -> cached t.inside | Before -> cached t.before | Cut -> compute ()

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

let forwards t seen =
  List.iter (enter t) t.starts;
  let rec go index done_ =
    match Times.min_binding_opt t.pending with
    | None -> Array.of_list (List.rev done_)
    | Some (time, layer) ->
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
  let size = t.question.graph.size in
  let inside s = Int_array.get seen s >= 0 in
  let loops = ref false in
  let successors s =
    let edges = Timed_graph.edges t.question.graph s in
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

(* [marks] has a byte for each rank, 0 before and after. Many ranks are marked and read in order, and few sorted. *)
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

let make question window starts =
  if is_open window then None
  else
    let size = question.graph.size in
    let t =
      {
        question;
        window;
        starts;
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
    forwards t seen;
    match rank t seen with
    | None -> None
    | Some (rank, node_of) ->
      t.rank <- rank;
      t.node_of <- node_of;
      let marks = Bytes.make (Int_array.length node_of) '\000' in
      Array.iter (fun layer -> sort t marks layer.nodes) t.layers;
      Some t

(* {1 Backwards: values} *)

exception Interrupted

(* What is computed of each place of a layer: its value, and the number of steps to the goal by choices that attain
   it, which is [never] if there are none. The arrays have an element for each place of the layer, or for each rank
   where that is not many more. *)
type 'a computed = { value : 'a array; steps : int array; by_rank : bool }

let never = max_int

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

type 'a backwards = {
  numbers : 'a Arithmetic.t;
  computed : 'a computed array;  (** of each layer; empty where it is not needed any more *)
  taken : Int_array.t array;
  (** Of each place the branch with the fewest steps to the goal, counted through all its choices. It is empty if
      no run is wanted. *)
}

let slot computed layer rank = if computed.by_rank then rank else index layer rank

let find b layer rank get ~goal ~fail =
  if rank = at_goal then goal
  else if rank = at_fail then fail
  else
    let computed = b.computed.(layer.index) in
    (get computed).(slot computed layer rank)

let rank_of t s = if s < 0 then s else Int_array.get t.rank s

let best_of (side : Timed_formula.side) compare a b =
  match side with Least -> if compare b a < 0 then b else a | Greatest -> if compare b a > 0 then b else a

(* The fewest steps by one of the choices with the best value, and the first branch that begins so. *)
let shortest t b layer choices values best =
  let least = ref never and taken = ref 0 and k = ref 0 in
  Array.iteri
    (fun c { target; delay; _ } ->
       let attains = b.numbers.compare values.(c) best = 0 in
       Array.iteri
         (fun i s ->
            if attains then begin
              let next = later t layer delay.(i) in
              let rest = find b next (rank_of t s) (fun c -> c.steps) ~goal:0 ~fail:never in
              if rest < !least then begin
                least := rest;
                taken := !k
              end
            end;
            incr k)
         target)
    choices;
  ((if !least = never then never else !least + 1), !taken)

let compute_place t b ~trace layer i =
  let rank = Int_array.get layer.nodes i in
  let s = Int_array.get t.node_of rank in
  let choices = choices_of t layer s in
  let value { weights; target; delay } =
    b.numbers.mean weights (fun k ->
        let next = if delay.(k) = 0 then layer else later t layer delay.(k) in
        find b next (rank_of t target.(k)) (fun c -> c.value) ~goal:b.numbers.one ~fail:b.numbers.zero)
  in
  let values = Array.map value choices in
  let best = Array.fold_left (best_of t.question.side b.numbers.compare) values.(0) values in
  let computed = b.computed.(layer.index) in
  let slot = if computed.by_rank then rank else i in
  computed.value.(slot) <- best;
  if trace then begin
    let steps, taken = shortest t b layer choices values best in
    computed.steps.(slot) <- steps;
    Int_array.set b.taken.(layer.index) i taken
  end

(* From the last layer back. [keep] is called once a layer is computed. *)
let backwards t (effort : Effort.t) numbers ~trace keep =
  let count = Array.length t.layers in
  let none = { value = [||]; steps = [||]; by_rank = false } in
  let b = { numbers; computed = Array.make count none; taken = Array.make count (Int_array.make 0 0) } in
  let over = Array.make count [] in
  Array.iter (fun layer -> over.(layer.first) <- layer.index :: over.(layer.first)) t.layers;
  for k = count - 1 downto 0 do
    if effort.interrupted () then raise Interrupted;
    let layer = t.layers.(k) in
    let n = Int_array.length layer.nodes in
    let ranks = Int_array.length t.node_of in
    let by_rank = n > ranks / 8 in
    let slots = if by_rank then ranks else n in
    b.computed.(k) <-
      { value = Array.make slots numbers.zero; steps = (if trace then Array.make slots never else [||]); by_rank };
    if trace then b.taken.(k) <- Int_array.make n 0;
    for i = 0 to n - 1 do
      compute_place t b ~trace layer i
    done;
    keep b layer;
    List.iter (fun l -> b.computed.(l) <- none) over.(k)
  done;
  b

(* {1 Values of the starts} *)

type values = Answer.t Places.t

let value values = function
  | Goal -> Answer.Exact Rat.one
  | Fail -> Exact Rat.zero
  | Go p -> Places.find values p

let layer_of t time =
  let rec find low high =
    let middle = (low + high) / 2 in
    let c = Rat.compare t.layers.(middle).time time in
    if c = 0 then t.layers.(middle) else if c < 0 then find (middle + 1) high else find low (middle - 1)
  in
  find 0 (Array.length t.layers - 1)

let by_time t =
  let table = Hashtbl.create 16 in
  let add = function
    | Goal | Fail | Go { elapsed = None; _ } -> ()
    | Go ({ elapsed = Some time; _ } as p) ->
      Hashtbl.add table (layer_of t time).index p
  in
  List.iter add t.starts;
  table

let rationals t effort numbers =
  let starts = by_time t and found = Places.create 16 in
  let keep b layer =
    let note (p : place) =
      let x = find b layer (rank_of t p.node) (fun c -> c.value) ~goal:numbers.Arithmetic.one ~fail:numbers.zero in
      Places.replace found p (numbers.to_rat x)
    in
    List.iter note (Hashtbl.find_all starts layer.index)
  in
  ignore (backwards t effort numbers ~trace:false keep);
  found

let map f table =
  let result = Places.create (Places.length table) in
  Places.iter (fun p x -> Places.replace result p (f p x)) table;
  result

let unknown t =
  let found = Places.create 16 in
  List.iter (function Go p -> Places.replace found p (Answer.Within (Rat.zero, Rat.one)) | Goal | Fail -> ()) t.starts;
  found

let enclosed t effort =
  let low = rationals t effort (Arithmetic.rounded Down) in
  let high = rationals t effort (Arithmetic.rounded Up) in
  map
    (fun p low ->
       let high = Places.find high p in
       if Rat.equal low high then Answer.Exact low else Within (low, high))
    low

(* Powers of a long base would be longer than the numbers themselves. *)
let longest_base = 64

type 'r user = { use : 'a. 'a Arithmetic.t -> 'r }

let exactly t (effort : Effort.t) { use } =
  if Z.numbits t.base <= longest_base then use (Arithmetic.exact ~base:t.base ~bits:effort.bits)
  else use (Arithmetic.rational ~bits:effort.bits)

let solve t (effort : Effort.t) =
  let exact () = map (fun _ x -> Answer.Exact x) (exactly t effort { use = (fun numbers -> rationals t effort numbers) }) in
  try
    match effort.engine with
    | Nearly -> enclosed t effort
    | Exactly -> exact ()
    | Either -> ( try exact () with Arithmetic.Too_long -> enclosed t effort)
  with Interrupted | Arithmetic.Too_long -> unknown t

(* {1 Runs} *)

let rec nth_branch choices k =
  match choices with
  | [] -> Scc_base.Bug.fail __POS__ "a branch that a place does not have"
  | branches :: rest ->
    let n = List.length branches in
    if k < n then List.nth branches k else nth_branch rest (k - n)

let follow t taken start =
  let rec go next trail =
    match next with
    | Goal -> List.rev trail
    | Fail | Go { elapsed = None; _ } -> Scc_base.Bug.fail __POS__ "a run to the goal does not come there"
    | Go ({ elapsed = Some time; node } as p) ->
      let layer = layer_of t time in
      let k = Int_array.get taken.(layer.index) (index layer (rank_of t node)) in
      let branch = nth_branch (Decisions.choices t.question t.window p) k in
      go branch.next ((p, branch) :: trail)
  in
  go start []

let traced t effort start numbers =
  let arrives = ref (match start with Goal -> true | Fail | Go _ -> false) in
  let keep b layer =
    match start with
    | Go { node; elapsed = Some time } when Rat.equal time layer.time ->
      arrives := find b layer (rank_of t node) (fun c -> c.steps) ~goal:0 ~fail:never < never
    | Goal | Fail | Go _ -> ()
  in
  let b = backwards t effort numbers ~trace:true keep in
  if !arrives then Some (follow t b.taken start) else None

let run t (effort : Effort.t) start =
  let exact () = exactly t effort { use = (fun numbers -> traced t effort start numbers) } in
  let near () =
    traced t effort start (Arithmetic.rounded (match t.question.side with Least -> Up | Greatest -> Down))
  in
  try
    match effort.engine with
    | _ when not t.free -> traced t effort start Arithmetic.nothing
    | Nearly -> near ()
    | Exactly -> exact ()
    | Either -> ( try exact () with Arithmetic.Too_long -> near ())
  with Interrupted | Arithmetic.Too_long -> None

(* {1 Arrivals} *)

module Moments = Set.Make (struct
    type t = Timeline.moment

    let compare = Timeline.compare_moment
  end)

let arrivals t =
  let known = Hashtbl.create 64 in
  let of_node layer rank =
    let s = Int_array.get t.node_of rank in
    let compute () = meetings t.question t.window { node = s; elapsed = Some layer.time } in
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
