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
  type edge = { label : int; target : int }
  type status = Expanded | Queued | Unexpanded of L.fault reason
  type step = { source : int; choice : int }
  type order = By_steps | By_time

  type t = {
    context : L.context;
    order : order;
    tuples : Tuples.t;
    near : Tuples.spread;  (** the state being expanded *)
    reader : Tuples.spread;  (** for those who ask *)
    depth : Int_vector.t;
    instant : Int_vector.t;  (** transitions without passing time at the end of the nearest path *)
    nearest : Int_vector.t;  (** the state before on the nearest path; -1 at the initial state *)
    earliest : (int, int) Hashtbl.t;  (** the state before on the earliest path, when that is another *)
    times : Rationals.t;
    arrival : Int_vector.t;  (** into [times] *)
    mutable marks : Bytes.t;  (** statuses *)
    faults : (int, L.fault) Hashtbl.t;
    frontier : Frontier.t;
    edges : kept option;
    mutable transitions : int;
    mutable turns : bool;
    mutable timed : Bytes.t;  (** whether labels take time, as far as is known *)
  }

  (* The edges of a state stand side by side, after their number. *)
  and kept = { first : Int_vector.t;  (** -1 for none *) labels : Int_vector.t; targets : Int_vector.t }

  type visitor = {
    found : t -> int -> int array -> unit;
    opened : (t -> int -> int array -> edge array -> unit) option;
    earlier : t -> int -> unit;
    enough : unit -> bool;
  }

  let blind =
    {
      found = (fun _ _ _ -> ());
      opened = None;
      earlier = (fun _ _ -> ());
      enough = (fun () -> false);
    }

  let context g = g.context
  let size g = Tuples.size g.tuples
  let depth g i = Int_vector.get g.depth i
  let arrival g i = Rationals.get g.times (Int_vector.get g.arrival i)
  let transitions g = g.transitions
  let turns g = g.turns
  let duration g e = L.duration g.context e.label

  let tuple g i =
    Tuples.load g.tuples g.reader i;
    Tuples.slots g.reader

  (** {2 Statuses} *)

  let codes = [| Depth; Time; Instant; States; Seconds; Memory; Interrupted; Stopped |]

  let code = function
    | Depth -> 0
    | Time -> 1
    | Instant -> 2
    | States -> 3
    | Seconds -> 4
    | Memory -> 5
    | Interrupted -> 6
    | Stopped -> 7
    | Fault _ -> 8

  let queued = 'q'
  let expanded = 'e'

  let status g i =
    match Bytes.get g.marks i with
    | 'q' -> Queued
    | 'e' -> Expanded
    | '8' -> Unexpanded (Fault (Hashtbl.find g.faults i))
    | c -> Unexpanded codes.(Char.code c - Char.code '0')

  let mark g i c =
    if i >= Bytes.length g.marks then begin
      let marks = Bytes.make (2 * i) queued in
      Bytes.blit g.marks 0 marks 0 i;
      g.marks <- marks
    end;
    Bytes.set g.marks i c

  let leave_out g i reason =
    (match reason with
     | Fault f -> Hashtbl.replace g.faults i f
     | Depth | Time | Instant | States | Seconds | Memory | Interrupted | Stopped -> ());
    mark g i (Char.chr (Char.code '0' + code reason))

  let is_expanded g i = Char.equal (Bytes.get g.marks i) expanded

  let unexpanded g =
    let rec from i acc =
      if i < 0 then acc
      else
        match status g i with
        | Unexpanded reason -> from (i - 1) ((i, reason) :: acc)
        | Expanded | Queued -> from (i - 1) acc
    in
    from (size g - 1) []

  let complete g =
    let rec from i = i = size g || (is_expanded g i && from (i + 1)) in
    from 0

  let greatest_depth g =
    let rec from i best = if i = size g then best else from (i + 1) (Int.max best (depth g i)) in
    from 0 0

  (* Few of the numbers of times differ from one state to the next. *)
  let greatest_arrival g =
    let rec from i last best =
      if i = size g then best
      else
        let a = Int_vector.get g.arrival i in
        from (i + 1) a (if a = last then best else Rat.max best (Rationals.get g.times a))
    in
    from 0 0 Rat.zero

  (** {2 Edges} *)

  (* Those that were put off when the state was expanded may lead to states that are not there. *)
  let edges_of_steps g steps =
    List.filter_map
      (fun (s : Lts.step) ->
         match Tuples.find g.tuples ~near:g.reader s.changes with
         | -1 -> None
         | target -> Some { label = s.label; target })
      steps
    |> Array.of_list

  let made_anew g i =
    let tuple = tuple g i in
    match L.successors g.context tuple with
    | Ok steps -> edges_of_steps g steps
    | Error _ -> Scc_base.Bug.fail __POS__ "the transitions of a state cannot be made again"

  let edges g i =
    if not (is_expanded g i) then [||]
    else
      match g.edges with
      | None -> made_anew g i
      | Some k ->
        let at = Int_vector.get k.first i in
        Array.init (Int_vector.get k.targets at) (fun n ->
            { label = Int_vector.get k.labels (at + n + 1); target = Int_vector.get k.targets (at + n + 1) })

  let keep g i edges =
    match g.edges with
    | None -> ()
    | Some k ->
      Int_vector.set k.first i (Int_vector.length k.targets);
      Int_vector.push k.labels 0;
      Int_vector.push k.targets (List.length edges);
      List.iter
        (fun e ->
           Int_vector.push k.labels e.label;
           Int_vector.push k.targets e.target)
        edges

  (** {2 Paths} *)

  let before_nearest g i = Int_vector.get g.nearest i

  let before_earliest g i =
    match Hashtbl.find_opt g.earliest i with Some j -> j | None -> before_nearest g i

  (* The first choice that leads from the one state to the other and passes the test. *)
  let choice g source target test =
    let edges = edges g source in
    let rec from k =
      if k = Array.length edges then Scc_base.Bug.fail __POS__ "a path without an edge"
      else if edges.(k).target = target && test edges.(k) then k
      else from (k + 1)
    in
    from 0

  let path g before test i =
    let rec go i acc =
      match before g i with
      | -1 -> acc
      | source -> go source ({ source; choice = choice g source i (test source i) } :: acc)
    in
    go i []

  let shortest_path g i = path g before_nearest (fun _ _ _ -> true) i

  let earliest_path g i =
    let in_time source target e = Rat.equal (arrival g target) (Rat.add (arrival g source) (duration g e)) in
    path g before_earliest in_time i

  (** {2 Bounds} *)

  let beyond value = function None -> false | Some bound -> value > (bound : int)

  (* Which of the bounds on states themselves keeps a state from being expanded. *)
  let out_of_bounds g (limits : Limits.t) i =
    if beyond (depth g i) limits.depth then Some Depth
    else if match limits.time with None -> false | Some t -> Rat.compare (arrival g i) t > 0 then Some Time
    else if beyond (Int_vector.get g.instant i) limits.instant then Some Instant
    else None

  type memory = { states : int; labels : int; edges : int }

  let memory g =
    let kept k = Int_vector.bytes k.first + Int_vector.bytes k.labels + Int_vector.bytes k.targets in
    {
      states = Tuples.bytes g.tuples;
      labels =
        Int_vector.bytes g.depth + Int_vector.bytes g.instant + Int_vector.bytes g.nearest
        + Int_vector.bytes g.arrival + Bytes.length g.marks;
      edges = Option.fold ~none:0 ~some:kept g.edges;
    }

  (* Of the heap and of what stands beside it. *)
  let words g =
    let m = memory g in
    (Gc.quick_stat ()).Gc.heap_words + ((m.states + m.labels + m.edges) / (Sys.word_size / 8))

  (* Which of the bounds on the exploration has been met. Looking at the memory costs more than the rest. *)
  let exhausted g (limits : Limits.t) (around : Limits.surroundings) ~start ~round =
    if around.interrupted () then Some Interrupted
    else if match limits.seconds with None -> false | Some s -> around.now () -. start > s then Some Seconds
    else if round land 255 = 0 && Option.is_some limits.memory && beyond (words g) limits.memory then
      Some Memory
    else None

  (** {2 Growing the graph} *)

  let add g i ~depth ~arrival ~instant ~before =
    Int_vector.push g.depth depth;
    Int_vector.push g.arrival arrival;
    Int_vector.push g.instant instant;
    Int_vector.push g.nearest before;
    Option.iter (fun k -> Int_vector.push k.first (-1)) g.edges;
    mark g i queued;
    Frontier.push g.frontier i (Rationals.get g.times arrival)

  (* Most transitions take no time: that is looked up once for each label. *)
  let takes_time g label =
    if label >= Bytes.length g.timed then begin
      let timed = Bytes.make (2 * (label + 1)) '?' in
      Bytes.blit g.timed 0 timed 0 (Bytes.length g.timed);
      g.timed <- timed
    end;
    match Bytes.unsafe_get g.timed label with
    | 'y' -> true
    | 'n' -> false
    | _ ->
      let yes = Rat.sign (L.duration g.context label) > 0 in
      Bytes.set g.timed label (if yes then 'y' else 'n');
      yes

  (* Times and instants after a transition. *)
  let after g i label =
    let arrival = Int_vector.get g.arrival i in
    if takes_time g label then
      let d = L.duration g.context label in
      (Rationals.intern g.times (Rat.add (Rationals.get g.times arrival) d), 0)
    else (arrival, Int_vector.get g.instant i + 1)

  (* Better labels for the target of an edge; whether there were any, and whether it is reached earlier. *)
  let improve g i e =
    let j = e.target in
    let arrival, instant = after g i e.label in
    let nearer = depth g i + 1 < depth g j in
    let known = Int_vector.get g.arrival j in
    let is_earlier =
      arrival <> known && Rat.compare (Rationals.get g.times arrival) (Rationals.get g.times known) < 0
    in
    (* An edge that leads deeper when it is found may not do so once a shorter path to its end is known. *)
    if nearer || (instant > 0 && depth g j <= depth g i) then g.turns <- true;
    if nearer || is_earlier then begin
      (* The two paths may be one, and then part here. *)
      let earliest = if is_earlier then i else before_earliest g j in
      if nearer then begin
        Int_vector.set g.depth j (depth g i + 1);
        Int_vector.set g.instant j instant;
        Int_vector.set g.nearest j i
      end;
      if is_earlier then Int_vector.set g.arrival j arrival;
      if earliest = before_nearest g j then Hashtbl.remove g.earliest j
      else Hashtbl.replace g.earliest j earliest
    end;
    (nearer || is_earlier, is_earlier)

  (* A state left out for its labels alone, and now within the bounds, is taken up again. *)
  let reconsider g limits i =
    match status g i with
    | Unexpanded (Depth | Time | Instant) when Option.is_none (out_of_bounds g limits i) ->
      mark g i queued;
      Frontier.push g.frontier i (arrival g i)
    | Queued -> (match g.order with By_steps -> () | By_time -> Frontier.push g.frontier i (arrival g i))
    | Expanded | Unexpanded _ -> ()

  (* Passes better labels on through edges known already. *)
  let settle g limits visitor first =
    let work = Queue.create () and waiting = Hashtbl.create 16 in
    let enter i =
      reconsider g limits i;
      if is_expanded g i && not (Hashtbl.mem waiting i) then begin
        Hashtbl.add waiting i ();
        Queue.push i work
      end
    in
    enter first;
    while not (Queue.is_empty work) do
      let i = Queue.pop work in
      Hashtbl.remove waiting i;
      Array.iter
        (fun e ->
           let better, is_earlier = improve g i e in
           if is_earlier then visitor.earlier g e.target;
           if better then enter e.target)
        (edges g i)
    done

  (* Whether the targets that are new fit a number of them. *)
  let fits g room tuple (steps : Lts.step list) =
    List.compare_length_with steps room <= 0
    ||
    let fresh = Hashtbl.create 16 in
    List.iter
      (fun (s : Lts.step) ->
         if Tuples.find g.tuples ~near:g.near s.changes < 0 then
           Hashtbl.replace fresh (Array.to_list (Tuples.apply s.changes tuple)) ())
      steps;
    Hashtbl.length fresh <= room

  (* The target of a transition, which may be new. *)
  let connect g visitor i tuple n ({ label; changes } : Lts.step) =
    let known = size g in
    let id = Tuples.intern_prepared g.tuples n in
    if id = known then begin
      let arrival, instant = after g i label in
      add g id ~depth:(depth g i + 1) ~arrival ~instant ~before:i;
      visitor.found g id (Tuples.apply changes tuple)
    end;
    id

  (* Whether an edge to a known state changes nothing: it takes no time, and leads deeper, but not by a shorter way. *)
  let is_plain g i label target =
    (not (takes_time g label))
    && Int_vector.get g.arrival target = Int_vector.get g.arrival i
    && depth g target = depth g i + 1

  let relax g limits visitor i e =
    if not (is_plain g i e.label e.target) then begin
      let better, is_earlier = improve g i e in
      if is_earlier then visitor.earlier g e.target;
      if better then settle g limits visitor e.target
    end

  let is_new g (s : Lts.step) = Tuples.find g.tuples ~near:g.near s.changes < 0

  let successors g tuple =
    match L.reduced g.context tuple with
    | Some steps when List.for_all (is_new g) steps -> Ok steps
    | Some _ | None -> L.successors g.context tuple

  (* Expands a state; or says what ends the exploration. *)
  let expand g (limits : Limits.t) visitor i =
    Tuples.load g.tuples g.near i;
    let tuple = Tuples.slots g.near in
    match successors g tuple with
    | Error fault ->
      leave_out g i (Fault fault);
      None
    | Ok steps when match limits.states with None -> false | Some n -> not (fits g (n - size g) tuple steps) ->
      Some States
    | Ok steps ->
      mark g i expanded;
      List.iteri (fun n (s : Lts.step) -> Tuples.prepare g.tuples ~near:g.near s.changes n) steps;
      let count = List.length steps in
      Tuples.fetch g.tuples count;
      let targets = List.mapi (connect g visitor i tuple) steps in
      g.transitions <- g.transitions + count;
      let edge (s : Lts.step) target = { label = s.label; target } in
      if Option.is_some g.edges then keep g i (List.map2 edge steps targets);
      List.iter2 (fun s target -> relax g limits visitor i (edge s target)) steps targets;
      (match visitor.opened with
       | None -> ()
       | Some opened -> opened g i tuple (Array.of_list (List.map2 edge steps targets)));
      None

  (* All that is left of the frontier, of which [i] has been taken already. *)
  let give_up g i reason =
    let leave i =
      match status g i with Queued -> leave_out g i reason | Expanded | Unexpanded _ -> ()
    in
    leave i;
    Frontier.iter leave g.frontier

  let empty context order keep_edges =
    let tuples = Tuples.create ~width:(L.width context) in
    let vector = Int_vector.create in
    {
      context; order; tuples;
      near = Tuples.spread tuples;
      reader = Tuples.spread tuples;
      depth = vector (); instant = vector (); nearest = vector ();
      earliest = Hashtbl.create 16;
      times = Rationals.create ();
      arrival = vector ();
      marks = Bytes.make 1024 queued;
      faults = Hashtbl.create 1;
      frontier = (match order with By_steps -> Frontier.by_steps () | By_time -> Frontier.by_time ());
      edges =
        (if keep_edges then Some { first = vector (); labels = vector (); targets = vector () } else None);
      transitions = 0;
      turns = false;
      timed = Bytes.empty;
    }

  let progress g i : Limits.progress =
    {
      states = size g;
      transitions = g.transitions;
      waiting = Frontier.length g.frontier;
      depth = depth g i;
      model_time = arrival g i;
    }

  (* Looks at a state that waited; or says what ends the exploration. *)
  let visit g limits visitor i =
    match (status g i, out_of_bounds g limits i) with
    | (Expanded | Unexpanded _), _ -> None
    | Queued, Some reason ->
      leave_out g i reason;
      None
    | Queued, None -> expand g limits visitor i

  let run ?(visitor = blind) ?(order = By_steps) ?(keep_edges = true) (limits : Limits.t)
      (around : Limits.surroundings) context =
    let g = empty context order keep_edges in
    let start = around.now () in
    let first = L.initial context in
    let i = Tuples.intern g.tuples ~near:g.near (Tuples.difference (Array.map (fun _ -> -1) first) first) in
    add g i ~depth:0 ~arrival:0 ~instant:0 ~before:(-1);
    visitor.found g i first;
    let rec loop round =
      match Frontier.take g.frontier with
      | None -> ()
      | Some i -> (
          let stop =
            if visitor.enough () then Some Stopped
            else
              match exhausted g limits around ~start ~round with
              | Some reason -> Some reason
              | None ->
                if round land 255 = 0 then around.progress (progress g i);
                visit g limits visitor i
          in
          match stop with
          | Some reason -> give_up g i reason
          | None -> loop (round + 1))
    in
    loop 0;
    g
end
