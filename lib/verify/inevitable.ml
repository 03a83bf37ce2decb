open Scc_exact

type arc = { target : int; duration : Rat.t; first : Timeline.moment option }
type node = Unexplored | Arcs of arc array | Ray of Timeline.moment option | Dead_end
type graph = { size : int; holds : int -> bool; node : int -> node }
type finish = Rests | Stops | Repeats of int | Passes of int option
type trace = { steps : (int * int) list; last : int; finish : finish }

type outcome = {
  avoided : trace option;
  zeno : trace option;
  unexplored : int list;
}

(* The subgraph of what avoids the goal altogether. *)
let avoiding g v =
  if g.holds v then []
  else
    match g.node v with
    | Unexplored | Ray _ | Dead_end -> []
    | Arcs arcs ->
      Array.to_list (Array.mapi (fun i a -> (i, a)) arcs)
      |> List.filter (fun (_, a) -> Option.is_none a.first && not (g.holds a.target))

(** The avoiding nodes, breadth-first, each with the step that leads to it. *)
type region = { order : int list; by : (int * int) option array }

let explore g =
  let by = Array.make g.size None and seen = Array.make g.size false in
  let queue = Queue.create () in
  let enter v step =
    if not seen.(v) then begin
      seen.(v) <- true;
      by.(v) <- step;
      Queue.push v queue
    end
  in
  if not (g.holds 0) then enter 0 None;
  let rec go acc =
    match Queue.take_opt queue with
    | None -> List.rev acc
    | Some v ->
      List.iter (fun (i, a) -> enter a.target (Some (v, i))) (avoiding g v);
      go (v :: acc)
  in
  let order = go [] in
  { order; by }

let path_to by v =
  let rec go v acc = match by.(v) with None -> acc | Some (u, i) -> go u ((u, i) :: acc) in
  go v []

let ending g region =
  let ends v =
    let trace finish = Some { steps = path_to region.by v; last = v; finish } in
    match g.node v with
    | Ray None -> trace Rests
    | Dead_end -> trace Stops
    | Ray (Some _) | Unexplored | Arcs _ -> None
  in
  List.find_map ends region.order

(* A cycle through the first arc inside a component that satisfies the test. *)
let lasso g region (components : Components.t) test =
  let inside v (_, a) = Int.equal components.number.(v) components.number.(a.target) in
  let cycle v (i, a) =
    let successors u =
      List.filter (inside u) (avoiding g u) |> List.map (fun (i, a) -> (a.target, i))
    in
    match Components.path ~successors ~from:a.target ~goal:(Int.equal v) with
    | None -> Scc_base.Bug.fail __POS__ "a component is not connected"
    | Some back ->
      let stem = path_to region.by v in
      { steps = stem @ ((v, i) :: back); last = v; finish = Repeats (List.length stem) }
  in
  let look v =
    List.find_opt (fun arc -> inside v arc && test (snd arc)) (avoiding g v) |> Option.map (cycle v)
  in
  List.find_map look region.order

(** {2 The bound of time: longest avoiding paths}

    A run avoids the goal within b when it does so until it passes b in the middle of a time transition;
    being later is better for it, so that only the longest path to each node counts. Once there are no
    cycles but those without duration, components are met in topological order. *)

(* A goal that begins at the moment, seen from a node reached at time [a], comes after the bound. *)
let comes_after bound a (m : Timeline.moment) =
  let c = Algebraic.compare_rat m.offset (Rat.sub bound a) in
  if m.attained then c > 0 else c >= 0

let arc_passes bound a (arc : arc) =
  Rat.sign arc.duration > 0
  &&
  match arc.first with
  | Some m -> comes_after bound a m
  | None -> Rat.compare (Rat.add a arc.duration) bound > 0

let passing g bound a v =
  match g.node v with
  | Ray None -> Some None
  | Ray (Some m) -> if comes_after bound a m then Some None else None
  | Unexplored | Dead_end -> None
  | Arcs arcs ->
    let rec go i =
      if i = Array.length arcs then None
      else if arc_passes bound a arcs.(i) then Some (Some i)
      else go (i + 1)
    in
    go 0

type longest = { time : Rat.t option array; last_step : (int * int) option array }

let reach l v a step =
  match l.time.(v) with
  | Some b when Rat.compare a b <= 0 -> ()
  | Some _ | None ->
    l.time.(v) <- Some a;
    l.last_step.(v) <- step

(* The member of a component that is reached last, and when. *)
let latest l members =
  let better acc v =
    match (acc, l.time.(v)) with
    | None, Some a -> Some (v, a)
    | Some (_, b), Some a when Rat.compare a b > 0 -> Some (v, a)
    | _ -> acc
  in
  match List.fold_left better None members with
  | Some entry -> entry
  | None -> Scc_base.Bug.fail __POS__ "an avoiding component is not reached"

(* Within a component no time passes: all its members are reached as late as its latest. *)
let spread g (components : Components.t) l k members =
  let entry, a = latest l members in
  let done_ = Hashtbl.create 8 in
  let queue = Queue.create () in
  let enter v =
    if not (Hashtbl.mem done_ v) then begin
      Hashtbl.add done_ v ();
      Queue.push v queue
    end
  in
  enter entry;
  while not (Queue.is_empty queue) do
    let u = Queue.pop queue in
    List.iter
      (fun (i, arc) ->
         let w = arc.target in
         if Int.equal components.number.(w) k && not (Hashtbl.mem done_ w) then begin
           l.time.(w) <- Some a;
           l.last_step.(w) <- Some (u, i);
           enter w
         end)
      (avoiding g u)
  done;
  a

let too_late g (components : Components.t) bound =
  let l = { time = Array.make g.size None; last_step = Array.make g.size None } in
  let groups = Components.members components in
  reach l 0 Rat.zero None;
  let leave k a v =
    List.iter
      (fun (i, arc) ->
         if not (Int.equal components.number.(arc.target) k) then
           reach l arc.target (Rat.add a arc.duration) (Some (v, i)))
      (avoiding g v)
  in
  let rec go k =
    if k < 0 then None
    else
      let a = spread g components l k groups.(k) in
      let passes v =
        Option.map
          (fun choice -> { steps = path_to l.last_step v; last = v; finish = Passes choice })
          (passing g bound a v)
      in
      match List.find_map passes groups.(k) with
      | Some trace -> Some trace
      | None ->
        List.iter (leave k a) groups.(k);
        go (k - 1)
  in
  go (components.count - 1)

let first_of options = List.find_map (fun f -> f ()) options

let search g ~within =
  let region = explore g in
  match region.order with
  | [] -> { avoided = None; zeno = None; unexplored = [] }
  | _ :: _ ->
    let components =
      Components.compute ~size:g.size ~roots:[ 0 ]
        ~successors:(fun v -> List.map (fun (_, a) -> a.target) (avoiding g v))
    in
    let avoided =
      first_of
        [
          (fun () -> ending g region);
          (fun () -> lasso g region components (fun a -> Rat.sign a.duration > 0));
          (fun () -> Option.bind within (too_late g components));
        ]
    in
    if Option.is_some avoided then { avoided; zeno = None; unexplored = [] }
    else
      let unexplored =
        List.filter (fun v -> match g.node v with Unexplored -> true | _ -> false) region.order
      in
      { avoided; zeno = lasso g region components (fun _ -> true); unexplored }
