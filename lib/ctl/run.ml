open Scc_data
open Scc_exact

type step = { source : int; move : Timed_graph.move }

type finish =
  | At_state
  | During of { moment : Timeline.moment; sample : Algebraic.t }
  | Rests
  | Stops
  | Repeats of int
  | Passes

type t = { start : Positions.position; steps : step list; last : int; finish : finish }

let goal r : Positions.position option =
  match r.finish with
  | At_state -> Some (Positions.start r.last)
  | During { sample; _ } -> Some { node = r.last; offset = sample }
  | Rests | Stops | Repeats _ | Passes -> None

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

(* Places in the order in which they were met, the start first: where, from which place, and by which move. *)
type region = {
  origin : Positions.position;
  nodes : int Growable.t;
  from : int Growable.t;
  by : int Growable.t;
}

let rec back r i acc =
  let before = Growable.get r.from i in
  if before < 0 then acc
  else
    let step = { source = Growable.get r.nodes before; move = move (Growable.get r.by i) } in
    back r before (step :: acc)

let search (g : Timed_graph.t) ?(by_time = false) ?bound (start : Positions.position) judge =
  let r = { origin = start; nodes = Growable.create (); from = Growable.create (); by = Growable.create () } in
  let times = Growable.create () in
  let keep_time = by_time || Option.is_some bound in
  let seen = Bits.create (if by_time then 0 else g.size) and met = Met.create 16 in
  let add node time from by =
    Growable.push r.nodes node;
    Growable.push r.from from;
    Growable.push r.by by;
    if keep_time then Growable.push times time
  in
  let is_new node time =
    if by_time then
      (not (Met.mem met (node, time)))
      && begin
        Met.replace met (node, time) ();
        true
      end
    else
      (not (Bits.mem seen node))
      && begin
        Bits.add seen node;
        true
      end
  in
  let is_inside i = i = 0 && Positions.is_inside start in
  let enter node time from by = if is_new node time then add node time from by in
  if Positions.is_inside start then add start.node Rat.zero (-1) 0 else enter start.node Rat.zero (-1) 0;
  let bound = Option.value bound ~default:Rat.zero in
  let rec go i =
    if i = Growable.length r.nodes then Error r
    else
      let node = Growable.get r.nodes i in
      let time = if keep_time then Growable.get times i else Rat.zero in
      let position = if is_inside i then start else Positions.start node in
      let left = Algebraic.add_rat (Rat.sub bound time) start.offset in
      match judge { position; left } with
      | Found result -> Ok { steps = back r i []; last = node; result }
      | Follow { edge; flow } ->
        if not (is_inside i) then
          Array.iteri
            (fun k t -> if edge t then enter t time i (code (Edge k)))
            (Timed_graph.edges g node);
        (match Timed_graph.flow g node with
         | Lasts (d, targets) ->
           let later = if keep_time then Rat.add time d else time in
           Array.iteri (fun k t -> if flow t then enter t later i (code (Flow k))) targets
         | No_flow | Forever -> ());
        go (i + 1)
  in
  go 0

(** {2 Cycles} *)

let moves g s =
  let edges = Array.mapi (fun k t -> (Timed_graph.Edge k, t)) (Timed_graph.edges g s) in
  let flow = Timed_graph.targets (Timed_graph.flow g s) in
  Array.append edges (Array.mapi (fun k t -> (Timed_graph.Flow k, t)) flow)

let route (g : Timed_graph.t) ~from ~goal ~inside =
  let source = Int_array.make g.size (-1) and by = Int_array.make g.size 0 in
  let queue = Queue.create () in
  let rec back v acc =
    if Int.equal v from then acc
    else
      let s = Int_array.get source v in
      back s ({ source = s; move = move (Int_array.get by v) } :: acc)
  in
  let enter s way v =
    if (not (Int.equal v from)) && Int_array.get source v < 0 then begin
      Int_array.set source v s;
      Int_array.set by v (code way);
      Queue.push v queue
    end
  in
  Queue.push from queue;
  let rec go () =
    match Queue.take_opt queue with
    | None -> None
    | Some v when Int.equal v goal -> Some (back v [])
    | Some v ->
      Array.iter (fun (way, t) -> if inside v way t then enter v way t) (moves g v);
      go ()
  in
  go ()

let path g ~from goal = route g ~from ~goal ~inside:(fun _ _ _ -> true)

let cycle g s ~inside =
  let edges = Timed_graph.edges g s in
  let rec first k = if inside s edges.(k) then k else first (k + 1) in
  let k = first 0 in
  let inside s (move : Timed_graph.move) t =
    match move with Edge _ -> inside s t | Flow _ -> false
  in
  match route g ~from:edges.(k) ~goal:s ~inside with
  | None -> Scc_base.Bug.fail __POS__ "a component is not connected"
  | Some home -> { source = s; move = Edge k } :: home

let lasso (g : Timed_graph.t) region ~cycle ~inside =
  let seen = Bits.create g.size in
  (* A start inside a flow is the first place, and no node. *)
  let first = if Positions.is_inside region.origin then 1 else 0 in
  let places = Growable.length region.nodes in
  for i = first to places - 1 do
    Bits.add seen (Growable.get region.nodes i)
  done;
  let is_seen = Bits.mem seen in
  let inside s move t = is_seen t && inside s move t in
  let successors s =
    moves g s |> Array.to_list
    |> List.filter (fun (move, t) -> inside s move t)
    |> List.map snd |> Array.of_list
  in
  let components = Strong_components.compute ~size:g.size ~inside:is_seen ~successors in
  let number = Strong_components.number components in
  let stays s move t = inside s move t && Int.equal (number s) (number t) in
  let closing i =
    let s = Growable.get region.nodes i in
    let good (move, t) = stays s move t && cycle s move in
    match List.find_opt good (Array.to_list (moves g s)) with
    | None -> None
    | Some (move, t) -> (
        match route g ~from:t ~goal:s ~inside:stays with
        | None -> Scc_base.Bug.fail __POS__ "a component is not connected"
        | Some home ->
          let stem = back region i [] in
          let finish = Repeats (List.length stem) in
          let steps = List.rev_append (List.rev stem) ({ source = s; move } :: home) in
          Some { start = region.origin; steps; last = s; finish })
  in
  let rec go i =
    if i >= places then None else match closing i with Some run -> Some run | None -> go (i + 1)
  in
  go first
