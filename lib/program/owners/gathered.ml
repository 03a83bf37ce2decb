open Scc_data
open Scc_exact
open Scc_ctl
open Scc_codec

module Kinds = Scc_data.Numbering.Make (Node.Step)

type t = {
  size : int;
  predicates : int;
  patterns : int;
  steady : int -> bool;
  directions : Node.direction array;  (** by owner *)
  come : int array;  (** by owner: nodes *)
  owners : Int_array.t;  (** by node *)
  ids : Int_array.t;
  kinds : Kinds.t;
  statuses : Bytes.t;
  truths : Bytes.t;  (** by predicate and node *)
  reasons : (int, string) Hashtbl.t;  (** of undecided truths *)
  along : (int, Truth.t Timeline.t) Hashtbl.t;  (** likewise, by predicate and node *)
  starts : Int_array.t;  (** of the transitions of a node among all *)
  counts : Int_array.t;  (** how many they are *)
  steps : Int_array.buffer;  (** the kind of each transition *)
  mutable targets : Int_array.t;
  mutable waiting : string list;  (** texts of transitions, whose sources may be unknown yet *)
  events : (int, (int * int) array) Hashtbl.t;  (** by pattern and node, where any happen *)
}

(* Statuses of nodes. *)
let missing = '\000'
let unknown = '\001'
let rests = '\002'
let steps = '\003'

let make ~size ~owners (w : Wanted.t) =
  let predicates = Array.length (Scc_state_space.Formulas.predicates w.formulas) in
  {
    size; predicates;
    patterns = Array.length w.patterns;
    steady = Wanted.steady w;
    directions = Array.init owners (fun _ -> Node.direction ());
    come = Array.make owners 0;
    owners = Int_array.make size 0; ids = Int_array.make size 0;
    kinds = Kinds.create ();
    statuses = Bytes.make size missing;
    truths = Bytes.make (predicates * size) '\000';
    reasons = Hashtbl.create 16; along = Hashtbl.create 16;
    starts = Int_array.make size 0; counts = Int_array.make size 0;
    steps = Int_array.buffer ();
    targets = Int_array.make 0 0;
    waiting = [];
    events = Hashtbl.create 16;
  }

let key g k node = (k * g.size) + node

let set_truth g node p (t : Truth.t) =
  let code =
    match t with
    | False -> '\000'
    | True -> '\001'
    | Undecided why ->
      Hashtbl.replace g.reasons (key g p node) why;
      '\002'
  in
  Bytes.set g.truths (key g p node) code

let add_node g owner (n : Node.t) =
  let node = n.number in
  if not (Char.equal (Bytes.get g.statuses node) missing) then raise (Packed.Malformed "a node comes twice");
  Int_array.set g.owners node owner;
  Int_array.set g.ids node g.come.(owner);
  g.come.(owner) <- g.come.(owner) + 1;
  Array.iteri (set_truth g node) n.truths;
  List.iter (fun (p, timeline) -> Hashtbl.replace g.along (key g p node) timeline) n.along;
  let happen (least, most) = least > 0 || most > 0 in
  List.iteri (fun k all -> if Array.exists happen all then Hashtbl.replace g.events (key g k node) all) n.counts;
  Int_array.set g.starts node (Int_array.size g.steps);
  match n.follows with
  | Unknown -> Bytes.set g.statuses node unknown
  | Rests -> Bytes.set g.statuses node rests
  | Steps all ->
    Bytes.set g.statuses node steps;
    Int_array.set g.counts node (Array.length all);
    Array.iter (fun step -> Int_array.push g.steps (Kinds.number g.kinds step)) all

let nodes g owner text =
  let source = Packed.source text and direction = g.directions.(owner) in
  while not (Packed.at_end source) do
    add_node g owner
      (Node.read direction ~size:g.size ~predicates:g.predicates ~patterns:g.patterns source)
  done

(* {1 Transitions} *)

let put_arc b ~source ~choice target =
  Packed.put_nat b source;
  Packed.put_nat b choice;
  Packed.put_nat b target

let arcs g text = g.waiting <- text :: g.waiting

let read_arcs g text =
  let s = Packed.source text in
  while not (Packed.at_end s) do
    let source = Packed.below g.size ~what:"the node" s in
    let choice = Packed.below (Int_array.get g.counts source) ~what:"the transition" s in
    let target = Packed.below g.size ~what:"the node" s in
    Int_array.set g.targets (Int_array.get g.starts source + choice) target
  done

let finish g =
  if Bytes.contains g.statuses missing then raise (Packed.Malformed "a node is missing");
  g.targets <- Int_array.make (Int_array.size g.steps) (-1);
  List.iter (read_arcs g) g.waiting;
  g.waiting <- [];
  for k = 0 to Int_array.length g.targets - 1 do
    if Int_array.get g.targets k < 0 then raise (Packed.Malformed "a transition is missing")
  done

(* {1 The graph} *)

let kind g k = Kinds.get g.kinds (Int_array.nth g.steps k)
let is_timed g k = Rat.sign (kind g k).duration > 0

(* The transitions of a node that take time, or those that take none. *)
let chosen g ~timed node =
  let start = Int_array.get g.starts node in
  let rec from k found =
    if k < start then found else from (k - 1) (if Bool.equal (is_timed g k) timed then k :: found else found)
  in
  from (start + Int_array.get g.counts node - 1) []

let targets g all = Array.of_list (List.map (Int_array.get g.targets) all)

let flow g node : Timed_graph.flow =
  if Char.equal (Bytes.get g.statuses node) rests then Forever
  else
    match chosen g ~timed:true node with
    | [] -> No_flow
    | k :: _ as all -> Lasts ((kind g k).duration, targets g all)

let drawn g node =
  let chances = List.map (fun k -> (kind g k).chance) (chosen g ~timed:false node) in
  if List.exists Option.is_some chances then Some (Array.of_list chances) else None

let graph g : Timed_graph.t =
  {
    size = g.size;
    known = (fun node -> not (Char.equal (Bytes.get g.statuses node) unknown));
    edges = (fun node -> targets g (chosen g ~timed:false node));
    drawn = drawn g;
    flow = flow g;
  }

let at g p node : Truth.t =
  match Bytes.get g.truths (key g p node) with
  | '\000' -> False
  | '\001' -> True
  | _ -> Undecided (Hashtbl.find g.reasons (key g p node))

let along g p node extent =
  match Hashtbl.find_opt g.along (key g p node) with
  | Some timeline -> timeline
  | None -> Timeline.constant extent (at g p node)

let predicates g : Eval.predicates = { at = at g; along = along g; steady = g.steady }

let counted g pattern node edge =
  match Hashtbl.find_opt g.events (key g pattern node) with Some all -> all.(edge) | None -> (0, 0)

let home g node = (Int_array.get g.owners node, Int_array.get g.ids node)
