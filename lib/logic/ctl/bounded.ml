open Scc_data
open Scc_exact

type times = int -> Timeline.moment option

let now = { Timeline.offset = Algebraic.zero; attained = true }

let in_time bound = function
  | None -> false
  | Some (m : Timeline.moment) ->
    let c = Algebraic.compare_rat m.offset bound in
    if m.attained then c <= 0 else c < 0

let shift d (m : Timeline.moment) = { m with offset = Algebraic.add_rat d m.offset }

let earliest times targets =
  let better a b = if Timeline.compare_moment b a < 0 then b else a in
  Array.fold_left (fun found t -> Option.merge better found (times t)) None targets

let latest times targets =
  let worse a b = if Timeline.compare_moment b a > 0 then b else a in
  Array.fold_left (fun found t -> Option.map2 worse found (times t)) (Some now) targets

(** {2 Shortest} *)

let least index ~generous ~bound ~f ~g =
  let graph = Timed_graph.graph index in
  let way = Until.ways graph ~f ~g in
  let times = Array.make graph.size None in
  let heap = Heap.create ~near:(fun _ -> 0.) ~compare:(fun (m, _) (n, _) -> Timeline.compare_moment m n) in
  let offer s m =
    if in_time bound (Some m) then
      match times.(s) with
      | Some old when Timeline.compare_moment old m <= 0 -> ()
      | Some _ | None ->
        times.(s) <- Some m;
        Heap.add heap (m, s)
  in
  for s = 0 to graph.size - 1 do
    if Positions.at g s then offer s now
    else if Positions.at f s then
      if not (graph.known s) then (if generous then offer s now)
      else
        match way s with
        | Lost | Passes -> ()
        | Reached -> (
            match Flow.entering ~f:(Positions.along f s) ~g:(Positions.along g s) with
            | Reached m -> offer s m
            | Lost _ | Passes -> ())
  done;
  (* What leads to the least in no time is as near, and needs no place in the heap. *)
  let same = Stack.create () in
  let relax least m s timed =
    if Positions.at f s then
      if timed then
        match (way s, Timed_graph.flow graph s) with
        | Passes, Lasts (d, _) -> offer s (shift d m)
        | _ -> ()
      else
        match times.(s) with
        | Some old when Timeline.compare_moment old m <= 0 -> ()
        | Some _ | None ->
          times.(s) <- least;
          Stack.push s same
  in
  let rec go () =
    match Heap.take heap with
    | None -> ()
    | Some (m, t) ->
      (match times.(t) with
       | Some best as least when Timeline.compare_moment m best <= 0 ->
         Stack.push t same;
         while not (Stack.is_empty same) do
           Timed_graph.iter_sources index (Stack.pop same) (relax least m)
         done
       | Some _ | None -> ());
      go ()
  in
  go ();
  fun s -> times.(s)

(** {2 Longest} *)

let greatest index ~generous ~f ~g =
  let graph = Timed_graph.graph index in
  let way = Until.ways graph ~f ~g in
  let certain = Until.every index ~generous ~f ~g in
  let inside s = Positions.at certain s && (not (Positions.at g s)) && graph.known s in
  (* No run goes round where g is certain: each component is one node, after those that it leads to. *)
  let components =
    Strong_components.compute ~size:graph.size ~inside ~successors:(Until.successors graph way)
  in
  let latest = Array.make (Strong_components.count components) now in
  let time s =
    let k = Strong_components.number components s in
    if k >= 0 then Some latest.(k) else if Positions.at certain s then Some now else None
  in
  let visit k s =
    let later m = if Timeline.compare_moment m latest.(k) > 0 then latest.(k) <- m in
    let leads delay t =
      match time t with
      | Some m -> later (delay m)
      | None -> Scc_base.Bug.fail __POS__ "what is certain leads to what is not"
    in
    Array.iter (leads Fun.id) (graph.edges s);
    match (graph.flow s, way s) with
    | Lasts (d, targets), Passes -> Array.iter (leads (shift d)) targets
    | _, Reached -> (
        match Flow.entering ~f:(Positions.along f s) ~g:(Positions.along g s) with
        | Reached m -> later m
        | Lost _ | Passes -> ())
    | _ -> ()
  in
  Strong_components.iter components visit;
  time

(** {2 As sets} *)

let set graph ~bound ~join ~f ~g times =
  let along s =
    let limit, arrival =
      match Timed_graph.flow graph s with
      | Lasts (d, targets) -> (Some (Algebraic.of_rat d), Option.map (shift d) (join times targets))
      | No_flow | Forever -> (None, None)
    in
    Flow.within ~bound ~limit ~f:(Positions.along f s) ~g:(Positions.along g s) arrival
  in
  Positions.make graph ~at:(fun s -> in_time bound (times s)) ~along

let some index ~generous ~bound ~f ~g =
  set (Timed_graph.graph index) ~bound ~join:earliest ~f ~g (least index ~generous ~bound ~f ~g)

let every index ~generous ~bound ~f ~g =
  set (Timed_graph.graph index) ~bound ~join:latest ~f ~g (greatest index ~generous ~f ~g)
