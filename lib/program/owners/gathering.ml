open Scc_exact
open Scc_ctl
open Scc_codec
open Scc_graph_search
open Scc_state_space
open Scc_successors

type t = {
  part : Part.t;
  mesh : Mesh.t;
  records : Records.t array;
  wanted : Wanted.t;
  near : Tuples.spread;
  nodes : Buffer.t;  (** to be sent to the first owner *)
  arcs : Buffer.t;  (** likewise *)
  mutable direction : Node.direction;
  mutable graph : Gathered.t option;  (** at the first owner, once it is known how large it is *)
  arrows : Records.arrow Queue.t;  (** from other owners: transitions to states of this one *)
  early : (int * char * string) Queue.t;  (** what has come at the first owner before its graph was made *)
  mutable answer : (Rat.t, string) result option;  (** of another owner *)
}

let make part mesh records wanted =
  {
    part; mesh; records; wanted;
    near = Tuples.spread (Part.table part);
    nodes = Buffer.create 65536; arcs = Buffer.create 65536;
    direction = Node.direction ();
    graph = None;
    arrows = Queue.create (); early = Queue.create ();
    answer = None;
  }

(* Kinds of messages: transitions to states of the receiver; nodes, and transitions by their numbers, for the first
   owner; and a question for the value of a number, with its answer. *)
let arrow = 'A'
let nodes = 'N'
let arcs = 'L'
let question = 'V'
let answer = 'W'

let filter g = Part.filter g.part
let context g = Filter.context (filter g)

let tell_graph graph owner kind text =
  if Char.equal kind nodes then Gathered.nodes graph owner text else Gathered.arcs graph text

let for_first g owner kind text =
  match g.graph with
  | Some graph -> tell_graph graph owner kind text
  | None -> Queue.push (owner, kind, text) g.early

(* {1 Values} *)

let value_here g ~number id extent offset =
  Tuples.load (Part.table g.part) g.near id;
  let tuple = Array.copy (Tuples.slots g.near) in
  Formulas.number_at (context g) tuple extent g.wanted.numbers.(number) offset

let answer_to g text =
  let s = Packed.source text in
  let number = Packed.below (Array.length g.wanted.numbers) ~what:"the number" s in
  let id = Packed.below (Part.size g.part) ~what:"the state" s in
  let extent = Node.read_extent s in
  let offset = Packed.rational s in
  let b = Buffer.create 16 in
  (match value_here g ~number id extent offset with
   | Ok value ->
     Packed.put_nat b 0;
     Packed.put_rational b value
   | Error why ->
     Packed.put_nat b 1;
     Node.put_text b why);
  Buffer.contents b

let read_answer text =
  let s = Packed.source text in
  if Packed.below 2 ~what:"the kind of an answer" s = 0 then Ok (Packed.rational s) else Error (Packed.text s)

let heard g peer kind text =
  let is_for_first kind = Mesh.number g.mesh = 0 && (Char.equal kind nodes || Char.equal kind arcs) in
  if Char.equal kind arrow then
    Records.read g.records.(peer) g.part ~sender:peer text (fun a -> Queue.push a g.arrows)
  else if is_for_first kind then for_first g peer kind text
  else if Char.equal kind question then Mesh.post g.mesh peer answer (answer_to g text)
  else if Char.equal kind answer then g.answer <- Some (read_answer text);
  Char.equal kind arrow || Char.equal kind question || is_for_first kind || Char.equal kind answer

let extent graph node = Timed_graph.extent (Timed_graph.flow (Gathered.graph graph) node)

let value g graph n node offset =
  let owner, id = Gathered.home graph node and number = Wanted.number g.wanted n in
  let extent = extent graph node in
  if owner = Mesh.number g.mesh then value_here g ~number id extent offset
  else begin
    let b = Buffer.create 32 in
    Packed.put_nat b number;
    Packed.put_nat b id;
    Node.put_extent b extent;
    Packed.put_rational b offset;
    g.answer <- None;
    Mesh.post g.mesh owner question (Buffer.contents b);
    let rec wait () =
      match g.answer with
      | Some answer -> answer
      | None ->
        Mesh.pump g.mesh (-1.);
        wait ()
    in
    wait ()
  end

(* {1 One state} *)

let step g (s : Lts.step) : Node.step =
  let context = context g in
  let chance =
    if Scc_calculus.Model.decides_by_chance (Network_lts.model context) then
      Catalogue.chance (Network_lts.catalogue context) s.label
    else None
  in
  { duration = Network_lts.duration context s.label; chance }

let predicates g = Formulas.predicates g.wanted.formulas

(* Those that change while time passes. *)
let along g tuple extent =
  let one p (predicate : On_the_fly.predicate) =
    match (predicate.along, extent) with
    | None, _ | _, Timeline.Instant -> None
    | Some along, _ ->
      let t : Truth.t Timeline.t = along tuple extent in
      if t.rest = [] && Truth.equal t.start t.first then None else Some (p, t)
  in
  List.filter_map Fun.id (Array.to_list (Array.mapi one (predicates g)))

let counts g tuple steps =
  let takes_none (s : Lts.step) = Rat.sign (Network_lts.duration (context g) s.label) = 0 in
  let at_once = List.filter takes_none steps in
  let by p (s : Lts.step) = Formulas.counted_by (context g) tuple s.label p in
  List.map (fun p -> Array.of_list (List.map (by p) at_once)) (Array.to_list g.wanted.patterns)

(* Its transitions are computed once more. *)
let look g ~is_expanded id tuple : Lts.step list * Node.follows =
  if not (is_expanded id) then ([], Unknown)
  else
    match Filter.look (filter g) tuple with
    | Ok (Moves steps, _) -> (steps, Steps (Array.of_list (List.map (step g) steps)))
    | Ok (Rests, _) -> ([], Rests)
    | Ok ((Ends _ | Stops), _) -> ([], Steps [||])
    | Ok (Fault _, _) | Error _ -> ([], Unknown)

(* {1 All states} *)

(* So much is sent at once. *)
let enough = 65536

let flush_to_first g buffer kind ~least =
  if Buffer.length buffer > least then begin
    let text = Buffer.contents buffer in
    Buffer.clear buffer;
    if Mesh.number g.mesh = 0 then for_first g 0 kind text else Mesh.send g.mesh 0 kind text
  end

let flush g ~least =
  let one peer =
    if Records.size g.records.(peer) > least then Mesh.send g.mesh peer arrow (Records.take g.records.(peer))
  in
  List.iter one (Mesh.others g.mesh);
  flush_to_first g g.nodes nodes ~least;
  flush_to_first g g.arcs arcs ~least

let put_arc g (numbers : Node_numbers.t) ~source ~choice id =
  Gathered.put_arc g.arcs ~source ~choice (numbers.number id)

let take_arrows g numbers =
  Queue.iter (fun (a : Records.arrow) -> put_arc g numbers ~source:a.before ~choice:a.choice a.id) g.arrows;
  Queue.clear g.arrows

let time_after g id (s : Node.step) =
  match Part.clock g.part with
  | None -> 0
  | Some clock ->
    let now = Clock.arrival clock id in
    if Rat.sign s.duration = 0 then now else Clock.number clock (Rat.add (Clock.time clock now) s.duration)

let follow g numbers ~source id tuple choice (s : Lts.step) =
  if Array.length s.changes = 0 then put_arc g numbers ~source ~choice id
  else
    let target = Tuples.apply s.changes tuple in
    let home = (Keys.fingerprint (Filter.keys (filter g)) target).(0) mod Mesh.count g.mesh in
    if home = Mesh.number g.mesh then
      match Tuples.find (Part.table g.part) ~near:g.near s.changes with
      | -1 -> Scc_base.Bug.fail __POS__ "a transition that is made again leads to no state"
      | target -> put_arc g numbers ~source ~choice target
    else
      let time = time_after g id (step g s) in
      Records.put g.records.(home) ~time ~instant:0 ~before:source ~choice target

let one_state g (numbers : Node_numbers.t) ~is_expanded id =
  Tuples.load (Part.table g.part) g.near id;
  let tuple = Tuples.slots g.near in
  let steps, follows = look g ~is_expanded id tuple in
  let source = numbers.number id in
  Node.put g.direction g.nodes
    {
      number = source; follows;
      truths = Array.map (fun (p : On_the_fly.predicate) -> p.at tuple) (predicates g);
      along = along g tuple (Node.extent follows);
      counts = counts g tuple steps;
    };
  List.iteri (follow g numbers ~source id tuple) steps

let few = 64

let gather_all g (numbers : Node_numbers.t) ~is_expanded =
  g.direction <- Node.direction ();
  if Mesh.number g.mesh = 0 then begin
    let graph = Gathered.make ~size:numbers.size ~owners:(Mesh.count g.mesh) g.wanted in
    g.graph <- Some graph;
    Queue.iter (fun (owner, kind, text) -> tell_graph graph owner kind text) g.early;
    Queue.clear g.early
  end;
  for id = 0 to Part.size g.part - 1 do
    if id land (few - 1) = few - 1 then begin
      flush g ~least:enough;
      Mesh.pump g.mesh 0.;
      take_arrows g numbers
    end;
    one_state g numbers ~is_expanded id
  done;
  flush g ~least:0;
  (* All transitions are at their targets. *)
  ignore (Mesh.gather g.mesh (fun _ -> ""));
  take_arrows g numbers;
  flush g ~least:0;
  ignore (Mesh.gather g.mesh (fun _ -> ""));
  let graph = g.graph in
  g.graph <- None;
  Option.iter Gathered.finish graph;
  graph

let gather g numbers ~is_expanded =
  try gather_all g numbers ~is_expanded
  with Packed.Malformed what -> Failure.refused "the graph of all owners: %s" what
