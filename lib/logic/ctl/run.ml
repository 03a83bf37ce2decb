open Scc_data
open Scc_exact

type step = { source : int; move : Timed_graph.move }

type finish =
  | At_state
  | During of { moment : Timeline.moment; sample : Algebraic.t }
  | Rests
  | Stops
  | Repeats of int
  | Passes of Algebraic.t

type t = { start : Positions.position; steps : step list; last : int; finish : finish }

let goal r : Positions.position option =
  match r.finish with
  | At_state -> Some (Positions.start r.last)
  | During { sample; _ } -> Some { node = r.last; offset = sample }
  | Rests | Stops | Repeats _ | Passes _ -> None

(* To a moment inside the flow of s; where an open interval begins there, an offset in it, before the limit too.
*)
let during graph ~f ~g ?limit s (moment : Timeline.moment) =
  let least = Option.merge (fun a b -> if Algebraic.compare a b <= 0 then a else b) in
  let next cuts =
    Array.fold_left
      (fun acc c -> if Algebraic.compare c moment.offset > 0 then least acc (Some c) else acc)
      None cuts
  in
  let sample =
    if moment.attained then moment.offset
    else
      let ending =
        match Timed_graph.flow graph s with
        | Lasts (d, _) -> Some (Algebraic.of_rat d)
        | No_flow | Forever -> None
      in
      let cuts set = next (Positions.along set s).Pieces.cuts in
      let high = least (least (cuts f) (cuts g)) (least ending limit) in
      Algebraic.of_rat (Pieces.inside moment.offset high)
  in
  During { moment; sample }

let append a b =
  let finish = match b.finish with Repeats k -> Repeats (k + List.length a.steps) | f -> f in
  { b with start = a.start; steps = List.rev_append (List.rev a.steps) b.steps; finish }

type place = { position : Positions.position; left : Algebraic.t }
type 'r judgement = Found of 'r | Follow of { edge : int -> bool; flow : int -> bool }
type 'r found = { steps : step list; last : int; result : 'r }

let code : Timed_graph.move -> int = function Edge k -> 2 * k | Flow k -> (2 * k) + 1
let move code = if code land 1 = 0 then Timed_graph.Edge (code / 2) else Flow (code / 2)

module Met = Hashtbl.Make (struct
    type t = int * Rat.t

    let equal (s, t) (u, v) = Int.equal s u && Rat.equal t v
    let hash (s, t) = (31 * s) + Rat.hash t
  end)

(* Places in the order in which they were met, the start first: where, from which place and by which move. *)
type tree = { nodes : int Growable.t; from : int Growable.t; by : int Growable.t }

type region = {
  origin : Positions.position;
  tree : tree;
  ways : int -> (Timed_graph.move * int) list;  (** that the search follows from a place, to places *)
}

let rec back tree i acc =
  let before = Growable.get tree.from i in
  if before < 0 then acc
  else
    let step = { source = Growable.get tree.nodes before; move = move (Growable.get tree.by i) } in
    back tree before (step :: acc)

(* A search: its places so far, when each was met, and which nodes were met, at which times if those matter. *)
type searched = {
  g : Timed_graph.t;
  start : Positions.position;
  tree : tree;
  keep_time : bool;
  by_time : bool;
  times : Rat.t Growable.t;  (** of places, if times are kept *)
  seen : Bits.t;
  met : unit Met.t;
  bound : Rat.t;
}

let is_new t node time =
  if t.by_time then
    (not (Met.mem t.met (node, time)))
    && begin
      Met.replace t.met (node, time) ();
      true
    end
  else
    (not (Bits.mem t.seen node))
    && begin
      Bits.add t.seen node;
      true
    end

let add t node time ~from ~by =
  Growable.push t.tree.nodes node;
  Growable.push t.tree.from from;
  Growable.push t.tree.by by;
  if t.keep_time then Growable.push t.times time

let enter t node time ~from ~by = if is_new t node time then add t node time ~from ~by

(* A start inside a flow is the first place, and no node. *)
let is_inside t i = i = 0 && Positions.is_inside t.start
let time t i = if t.keep_time then Growable.get t.times i else Rat.zero

let judged t judge i =
  let position = if is_inside t i then t.start else Positions.start (Growable.get t.tree.nodes i) in
  judge { position; left = Algebraic.add_rat (Rat.sub t.bound (time t i)) t.start.offset }

(* The ways from a place that may be taken: each move, with the node that it leads to and when. *)
let iter_ways t i ~edge ~flow f =
  let node = Growable.get t.tree.nodes i and time = time t i in
  if not (is_inside t i) then
    Array.iteri (fun k n -> if edge n then f (Timed_graph.Edge k) n time) (Timed_graph.edges t.g node);
  match Timed_graph.flow t.g node with
  | Lasts (d, targets) ->
    let later = if t.keep_time then Rat.add time d else time in
    Array.iteri (fun k n -> if flow n then f (Timed_graph.Flow k) n later) targets
  | No_flow | Forever -> ()

(* Places by the node, and by the time if that matters. *)
let places t =
  let known = Met.create 64 in
  for i = if is_inside t 0 then 1 else 0 to Growable.length t.tree.nodes - 1 do
    Met.replace known (Growable.get t.tree.nodes i, if t.by_time then time t i else Rat.zero) i
  done;
  known

let ways_of t judge places i =
  match judged t judge i with
  | Found _ -> []
  | Follow { edge; flow } ->
    let found = ref [] in
    let add move n time =
      found := (move, Met.find (Lazy.force places) (n, if t.by_time then time else Rat.zero)) :: !found
    in
    iter_ways t i ~edge ~flow add;
    List.rev !found

let search (g : Timed_graph.t) ?(by_time = false) ?bound (start : Positions.position) judge =
  let tree = { nodes = Growable.create (); from = Growable.create (); by = Growable.create () } in
  let t =
    { g; start; tree; by_time; keep_time = by_time || Option.is_some bound; times = Growable.create ();
      seen = Bits.create (if by_time then 0 else g.size); met = Met.create 16;
      bound = Option.value bound ~default:Rat.zero }
  in
  if Positions.is_inside start then add t start.node Rat.zero ~from:(-1) ~by:0
  else enter t start.node Rat.zero ~from:(-1) ~by:0;
  let rec go i =
    if i = Growable.length tree.nodes then
      Error { origin = start; tree; ways = ways_of t judge (lazy (places t)) }
    else
      match judged t judge i with
      | Found result -> Ok { steps = back tree i []; last = Growable.get tree.nodes i; result }
      | Follow { edge; flow } ->
        iter_ways t i ~edge ~flow (fun move n time -> enter t n time ~from:i ~by:(code move));
        go (i + 1)
  in
  go 0

(** {2 Cycles} *)

(* From a place to another by some of the ways. *)
let route size ~ways ~from ~goal =
  let source = Int_array.make size (-1) and by = Int_array.make size 0 in
  let queue = Queue.create () in
  let rec back i acc =
    if Int.equal i from then acc
    else
      let s = Int_array.get source i in
      back s ((s, move (Int_array.get by i)) :: acc)
  in
  let enter i (way, j) =
    if (not (Int.equal j from)) && Int_array.get source j < 0 then begin
      Int_array.set source j i;
      Int_array.set by j (code way);
      Queue.push j queue
    end
  in
  Queue.push from queue;
  let rec go () =
    match Queue.take_opt queue with
    | None -> Scc_base.Bug.fail __POS__ "a component is not connected"
    | Some i when Int.equal i goal -> back i []
    | Some i ->
      List.iter (enter i) (ways i);
      go ()
  in
  go ()

let lasso (region : region) ~prefer =
  let size = Growable.length region.tree.nodes in
  let successors i = Array.of_list (List.map snd (region.ways i)) in
  let components = Strong_components.compute ~size ~inside:(fun _ -> true) ~successors in
  let number = Strong_components.number components in
  let staying i = List.filter (fun (_, j) -> Int.equal (number i) (number j)) (region.ways i) in
  let step (i, move) = { source = Growable.get region.tree.nodes i; move } in
  let closed i (move, j) =
    let home = route size ~ways:staying ~from:j ~goal:i in
    let stem = back region.tree i [] in
    let finish = Repeats (List.length stem) in
    let steps = List.rev_append (List.rev stem) (List.map step ((i, move) :: home)) in
    { start = region.origin; steps; last = Growable.get region.tree.nodes i; finish }
  in
  let rec first good i =
    if i = size then None
    else
      match List.find_opt (fun (move, _) -> good move) (staying i) with
      | Some way -> Some (closed i way)
      | None -> first good (i + 1)
  in
  match first prefer 0 with
  | Some run -> Some run
  | None -> first (fun _ -> true) 0
