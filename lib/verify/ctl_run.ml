open Scc_exact

type step = { source : int; move : Timed_graph.move }

type finish =
  | At_state
  | During of { moment : Timeline.moment; sample : Algebraic.t }
  | Rests
  | Stops
  | Repeats of int
  | Passes

type t = { start : Ctl_set.position; steps : step list; last : int; finish : finish }

let goal r : Ctl_set.position option =
  match r.finish with
  | At_state -> Some (Ctl_set.start r.last)
  | During { sample; _ } -> Some { node = r.last; offset = sample }
  | Rests | Stops | Repeats _ | Passes -> None

let append a b =
  let finish = match b.finish with Repeats k -> Repeats (k + List.length a.steps) | f -> f in
  { b with start = a.start; steps = List.rev_append (List.rev a.steps) b.steps; finish }

type place = { position : Ctl_set.position; left : Algebraic.t }
type 'r judgement = Found of 'r | Follow of { edge : int -> bool; flow : int -> bool }
type 'r found = { steps : step list; last : int; result : 'r }

(* A node, whether it stands for the start inside its flow, and the time of the steps to it when that counts. *)
module Key = struct
  type t = { node : int; inside : bool; time : Rat.t }

  let equal a b = Int.equal a.node b.node && Bool.equal a.inside b.inside && Rat.equal a.time b.time
  let hash k = (31 * k.node) + Rat.hash k.time
end

module Table = Hashtbl.Make (Key)

type region = {
  origin : Ctl_set.position;
  by : (Key.t * step) option Table.t;
  order : Key.t Queue.t;  (** as they were met *)
}

let rec back by key acc =
  match Table.find by key with None -> acc | Some (before, step) -> back by before (step :: acc)

let search g ?(by_time = false) ?(bound = Rat.zero) (start : Ctl_set.position) judge =
  let by = Table.create 64 and order = Queue.create () in
  let queue = Queue.create () in
  let enter node inside time source =
    let key = { Key.node; inside; time = (if by_time then time else Rat.zero) } in
    if not (Table.mem by key) then begin
      Table.replace by key source;
      Queue.push key order;
      Queue.push (key, time) queue
    end
  in
  enter start.node (Ctl_set.is_inside start) Rat.zero None;
  let rec go () =
    match Queue.take_opt queue with
    | None -> Error { origin = start; by; order }
    | Some ((key : Key.t), time) -> (
        let position = if key.inside then start else Ctl_set.start key.node in
        let left = Algebraic.add_rat (Rat.sub bound time) start.offset in
        match judge { position; left } with
        | Found result -> Ok { steps = back by key []; last = key.node; result }
        | Follow { edge; flow } ->
          let follow allowed move delay k t =
            if allowed t then
              enter t false (Rat.add time delay) (Some (key, { source = key.node; move = move k }))
          in
          if not key.inside then
            Array.iteri (follow edge (fun k -> Timed_graph.Edge k) Rat.zero) (Timed_graph.edges g key.node);
          (match Timed_graph.flow g key.node with
           | Lasts (d, targets) -> Array.iteri (follow flow (fun k -> Timed_graph.Flow k) d) targets
           | No_flow | Forever -> ());
          go ())
  in
  go ()

(** {2 Cycles} *)

let moves g s =
  let edges = Array.mapi (fun k t -> (Timed_graph.Edge k, t)) (Timed_graph.edges g s) in
  let flow = Timed_graph.targets (Timed_graph.flow g s) in
  Array.append edges (Array.mapi (fun k t -> (Timed_graph.Flow k, t)) flow)

let route g ~from ~goal ~inside =
  let by = Hashtbl.create 64 and queue = Queue.create () in
  let rec back v acc =
    match Hashtbl.find by v with None -> acc | Some step -> back step.source (step :: acc)
  in
  let enter v source =
    if not (Hashtbl.mem by v) then begin
      Hashtbl.replace by v source;
      Queue.push v queue
    end
  in
  enter from None;
  let rec go () =
    match Queue.take_opt queue with
    | None -> None
    | Some v when Int.equal v goal -> Some (back v [])
    | Some v ->
      Array.iter (fun (move, t) -> if inside v move t then enter t (Some { source = v; move })) (moves g v);
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

let lasso g region ~cycle ~inside =
  let seen = Hashtbl.create 64 in
  Queue.iter (fun (k : Key.t) -> if not k.inside then Hashtbl.replace seen k.node ()) region.order;
  let is_seen = Hashtbl.mem seen in
  let inside s move t = is_seen t && inside s move t in
  let successors s =
    moves g s |> Array.to_list
    |> List.filter (fun (move, t) -> inside s move t)
    |> List.map snd |> Array.of_list
  in
  let components = Ctl_components.compute ~size:g.size ~inside:is_seen ~successors in
  let number = Ctl_components.number components in
  let stays s move t = inside s move t && Int.equal (number s) (number t) in
  let closing (key : Key.t) =
    let s = key.node in
    let good (move, t) = stays s move t && cycle s move in
    match if key.inside then None else List.find_opt good (Array.to_list (moves g s)) with
    | None -> None
    | Some (move, t) -> (
        match route g ~from:t ~goal:s ~inside:stays with
        | None -> Scc_base.Bug.fail __POS__ "a component is not connected"
        | Some home ->
          let stem = back region.by key [] in
          let finish = Repeats (List.length stem) in
          Some { start = region.origin; steps = stem @ ({ source = s; move } :: home); last = s; finish })
  in
  Queue.fold (fun found key -> match found with Some _ -> found | None -> closing key) None region.order
