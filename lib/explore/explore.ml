open Scc_exact

type 'fault reason =
  | Depth
  | Time
  | Instant
  | States
  | Seconds
  | Memory
  | Interrupted
  | Stopped
  | Fault of 'fault

module Make (L : Lts.S) = struct
  type edge = { transition : L.transition; target : int }
  type status = Expanded | Queued | Unexpanded of L.fault reason
  type event = Found of int | Opened of int | Earlier of int
  type decision = Continue | Stop
  type step = { source : int; choice : int }

  type node = {
    state : L.state;
    mutable edges : edge array;
    mutable status : status;
    mutable depth : int;
    mutable arrival : Rat.t;
    mutable instant : int;  (** transitions without passing time at the end of the shortest path *)
    mutable nearest : step option;  (** last step of the shortest path *)
    mutable earliest : step option;  (** last step of the earliest path *)
    mutable improving : bool;  (** already in the queue of {!settle} *)
  }

  (* The hash is kept: growing the table must not hash whole states again. *)
  module Key = struct
    type t = { state : L.state; hash : int }

    let equal a b = Int.equal a.hash b.hash && L.equal a.state b.state
    let hash k = k.hash land max_int
  end

  module Table = Hashtbl.Make (Key)

  type t = {
    nodes : node Growable.t;
    table : int Table.t;
    queue : int Queue.t;
    mutable transitions : int;
  }

  let size g = Growable.length g.nodes
  let node g i = Growable.get g.nodes i
  let state g i = (node g i).state
  let status g i = (node g i).status
  let edges g i = (node g i).edges
  let depth g i = (node g i).depth
  let arrival g i = (node g i).arrival
  let transitions g = g.transitions
  let key state : Key.t = { state; hash = L.hash state }
  let find g state = Table.find_opt g.table (key state)

  let fold f g acc =
    let rec go i acc = if i = size g then acc else go (i + 1) (f i (node g i) acc) in
    go 0 acc

  let greatest_depth g = fold (fun _ n acc -> Int.max n.depth acc) g 0
  let greatest_arrival g = fold (fun _ n acc -> Rat.max n.arrival acc) g Rat.zero

  let unexpanded g =
    List.rev
      (fold (fun i n acc -> match n.status with Unexpanded r -> (i, r) :: acc | _ -> acc) g [])

  let complete g =
    fold (fun _ n acc -> acc && match n.status with Expanded -> true | _ -> false) g true

  let path g last i =
    let rec go i acc =
      match last (node g i) with None -> acc | Some step -> go step.source (step :: acc)
    in
    go i []

  let shortest_path g i = path g (fun n -> n.nearest) i
  let earliest_path g i = path g (fun n -> n.earliest) i

  (** {2 Bounds} *)

  let beyond value = function None -> false | Some bound -> value > (bound : int)

  (* Which of the bounds on states themselves keeps a state from being expanded. *)
  let out_of_bounds (limits : Limits.t) n =
    if beyond n.depth limits.depth then Some Depth
    else if match limits.time with None -> false | Some t -> Rat.compare n.arrival t > 0 then Some Time
    else if beyond n.instant limits.instant then Some Instant
    else None

  (* Which of the bounds on the exploration has been met. Looking at the heap costs more than the rest. *)
  let exhausted (limits : Limits.t) (around : Limits.surroundings) ~start ~round =
    if around.interrupted () then Some Interrupted
    else if match limits.seconds with None -> false | Some s -> around.now () -. start > s then Some Seconds
    else if round land 63 = 0 && Option.is_some limits.memory
            && beyond (Gc.quick_stat ()).Gc.heap_words limits.memory
    then Some Memory
    else None

  (** {2 Growing the graph} *)

  let add g ~depth ~arrival ~instant ~by state key =
    let i = size g in
    Growable.push g.nodes
      { state; edges = [||]; status = Queued; depth; arrival; instant;
        nearest = by; earliest = by; improving = false };
    Table.add g.table key i;
    Queue.push i g.queue;
    i

  let instant_after n duration = if Rat.sign duration > 0 then 0 else n.instant + 1

  (* Better labels for the target of an edge; whether there were any, and whether it is reached earlier. *)
  let improve n step duration target =
    let depth = n.depth + 1 and arrival = Rat.add n.arrival duration in
    let nearer = depth < target.depth in
    if nearer then begin
      target.depth <- depth;
      target.nearest <- Some step;
      target.instant <- instant_after n duration
    end;
    let earlier = Rat.compare arrival target.arrival < 0 in
    if earlier then begin
      target.arrival <- arrival;
      target.earliest <- Some step
    end;
    (nearer || earlier, earlier)

  (* A state left out for its labels alone, and now within the bounds, is taken up again. *)
  let reconsider g limits i n =
    match n.status with
    | Unexpanded (Depth | Time | Instant) when Option.is_none (out_of_bounds limits n) ->
      n.status <- Queued;
      Queue.push i g.queue
    | _ -> ()

  (* Passes better labels on through edges known already. *)
  let settle g limits ~tell first =
    let work = Queue.create () in
    let enter i =
      let n = node g i in
      reconsider g limits i n;
      if (not n.improving) && Array.length n.edges > 0 then begin
        n.improving <- true;
        Queue.push i work
      end
    in
    enter first;
    while not (Queue.is_empty work) do
      let i = Queue.pop work in
      let n = node g i in
      n.improving <- false;
      Array.iteri
        (fun choice e ->
           let step = { source = i; choice } in
           let better, earlier = improve n step (L.duration e.transition) (node g e.target) in
           if earlier then tell (Earlier e.target);
           if better then enter e.target)
        n.edges
    done

  (* How many of the targets are new, up to one more than [room]. *)
  let fits g room targets =
    match room with
    | None -> true
    | Some room ->
      let fresh = Table.create 8 in
      let rec go = function
        | [] -> true
        | k :: rest ->
          if not (Table.mem g.table k) then Table.replace fresh k ();
          Table.length fresh <= room && go rest
      in
      go targets

  let connect g limits ~tell i n choice transition key =
    let step = { source = i; choice } and duration = L.duration transition in
    match Table.find_opt g.table key with
    | None ->
      let target =
        add g ~depth:(n.depth + 1) ~arrival:(Rat.add n.arrival duration)
          ~instant:(instant_after n duration) ~by:(Some step) (L.target transition) key
      in
      tell (Found target);
      { transition; target }
    | Some target ->
      let better, earlier = improve n step duration (node g target) in
      if earlier then tell (Earlier target);
      if better then settle g limits ~tell target;
      { transition; target }

  (* Expands a state; or says what ends the exploration. *)
  let expand g (limits : Limits.t) ~tell context i n =
    match L.successors context n.state with
    | Error fault ->
      n.status <- Unexpanded (Fault fault);
      None
    | Ok list ->
      let keys = List.map (fun t -> key (L.target t)) list in
      let room = Option.map (fun bound -> bound - size g) limits.states in
      if not (fits g room keys) then Some States
      else begin
        n.status <- Expanded;
        let made =
          List.rev
            (snd
               (List.fold_left2
                  (fun (choice, acc) t k ->
                     (choice + 1, connect g limits ~tell i n choice t k :: acc))
                  (0, []) list keys))
        in
        n.edges <- Array.of_list made;
        g.transitions <- g.transitions + Array.length n.edges;
        tell (Opened i);
        None
      end

  let give_up g reason =
    Queue.iter
      (fun i ->
         let n = node g i in
         match n.status with Queued -> n.status <- Unexpanded reason | _ -> ())
      g.queue;
    Queue.clear g.queue

  let run ?(visit = fun _ _ -> Continue) (limits : Limits.t) (around : Limits.surroundings) context =
    let g =
      { nodes = Growable.create (); table = Table.create 1024; queue = Queue.create (); transitions = 0 }
    in
    let start = around.now () in
    let stopped = ref false in
    let tell event = match visit g event with Continue -> () | Stop -> stopped := true in
    let first = L.initial context in
    tell (Found (add g ~depth:0 ~arrival:Rat.zero ~instant:0 ~by:None first (key first)));
    (* The state at the head stays in the queue until it is settled, so that giving up marks it too. *)
    let rec loop round =
      if not (Queue.is_empty g.queue) then
        if !stopped then give_up g Stopped
        else
          match exhausted limits around ~start ~round with
          | Some reason -> give_up g reason
          | None ->
            let i = Queue.peek g.queue in
            let n = node g i in
            if round land 255 = 0 then
              around.progress { states = size g; waiting = Queue.length g.queue; depth = n.depth };
            let stop =
              match (n.status, out_of_bounds limits n) with
              | (Expanded | Unexpanded _), _ -> None
              | Queued, Some reason ->
                n.status <- Unexpanded reason;
                None
              | Queued, None -> expand g limits ~tell context i n
            in
            match stop with
            | Some reason -> give_up g reason
            | None ->
              ignore (Queue.pop g.queue);
              loop (round + 1)
    in
    loop 0;
    g

  let replay context choices =
    let rec go state i acc = function
      | [] -> Ok (List.rev acc)
      | choice :: rest -> (
          match L.successors context state with
          | Error fault -> Error (i, Some fault)
          | Ok list -> (
              match if choice < 0 then None else List.nth_opt list choice with
              | None -> Error (i, None)
              | Some t -> go (L.target t) (i + 1) (t :: acc) rest))
    in
    go (L.initial context) 0 [] choices
end
