open Scc_exact

type 'fault reason = 'fault Statuses.reason =
  | Depth
  | Time
  | Instant
  | States
  | Bits
  | Seconds
  | Memory
  | Interrupted
  | Stopped
  | Fault of 'fault

let of_stop = Statuses.of_stop

type 'fault status = 'fault Statuses.status = Expanded | Queued | Unexpanded of 'fault reason

module Make (L : Lts.S) = struct
  type edge = { label : int; target : int }
  type step = { source : int; choice : int }
  type order = By_steps | By_time

  type t = {
    context : L.context;
    order : order;
    tuples : Tuples.t;
    near : Tuples.spread;  (** the state being expanded *)
    reader : Tuples.spread;  (** for those who ask *)
    distances : Distances.t;
    statuses : L.fault Statuses.t;
    frontier : Frontier.t;
    edges : Edge_store.t option;
    mutable transitions : int;
    mutable turns : bool;
    timed : Timed_labels.t;
  }

  type visitor = {
    found : t -> int -> int array -> unit;
    opened : (t -> int -> int array -> edge array -> unit) option;
    earlier : t -> int -> unit;
    enough : unit -> bool;
    matters : Rat.t -> bool;
  }

  let blind =
    {
      matters = (fun _ -> true);
      found = (fun _ _ _ -> ());
      opened = None;
      earlier = (fun _ _ -> ());
      enough = (fun () -> false);
    }

  let context g = g.context
  let size g = Tuples.size g.tuples
  let depth g i = Distances.depth g.distances i
  let arrival g i = Distances.arrival g.distances i
  let transitions g = g.transitions
  let turns g = g.turns
  let duration g e = L.duration g.context e.label

  let tuple g i =
    Tuples.load g.tuples g.reader i;
    Tuples.slots g.reader

  (** {2 Statuses} *)

  let status g i = Statuses.get g.statuses i
  let is_expanded g i = Statuses.is_expanded g.statuses i
  let mark g i status = Statuses.set g.statuses i status
  let leave_out g i reason = mark g i (Unexpanded reason)

  let unexpanded g =
    let reason i = match status g i with Unexpanded reason -> [ (i, reason) ] | Expanded | Queued -> [] in
    let rec from i acc = if i < 0 then acc else from (i - 1) (reason i @ acc) in
    from (size g - 1) []

  let complete g =
    let rec from i = i = size g || (is_expanded g i && from (i + 1)) in
    from 0

  let greatest_depth g = Distances.greatest_depth g.distances
  let greatest_arrival g = Distances.greatest_arrival g.distances

  (** {2 Edges} *)

  let takes_time g label = Timed_labels.takes_time g.timed label ~duration:(L.duration g.context)

  (* Those that were put off when the state was expanded may lead to states that are not there. *)
  let edges_of_steps g steps =
    let edge (s : Lts.step) =
      match Tuples.find g.tuples ~near:g.reader s.changes with
      | -1 -> None
      | target -> Some { label = s.label; target }
    in
    Array.of_list (List.filter_map edge steps)

  let made_anew g i =
    let tuple = tuple g i in
    match L.successors g.context tuple with
    | Ok steps -> edges_of_steps g steps
    | Error _ -> Scc_base.Bug.fail __POS__ "the transitions of a state cannot be made again"

  (* Of a state whose transitions have been made, though it may not have been looked at to the end. *)
  let known_edges g i =
    match g.edges with
    | None -> made_anew g i
    | Some store -> Edge_store.get store i (fun label target -> { label; target })

  let edges g i = if is_expanded g i then known_edges g i else [||]

  let passing g i =
    let timed e = takes_time g e.label in
    let label =
      match g.edges with
      | Some store when is_expanded g i -> Edge_store.find_label store i (takes_time g)
      | Some _ | None -> Option.map (fun e -> e.label) (List.find_opt timed (Array.to_list (edges g i)))
    in
    Option.map (L.duration g.context) label

  let targets g ~timed i =
    let wanted label = Bool.equal timed (takes_time g label) in
    match g.edges with
    | Some store when is_expanded g i -> Edge_store.targets store i wanted
    | Some _ | None ->
      let fitting = List.filter (fun e -> wanted e.label) (Array.to_list (edges g i)) in
      Array.of_list (List.map (fun e -> e.target) fitting)

  (** {2 Paths} *)

  (* The first choice that leads from the one state to the other and passes the test. *)
  let choice g source target test =
    let edges = known_edges g source in
    let rec from k =
      if k = Array.length edges then Scc_base.Bug.fail __POS__ "a path without an edge"
      else if edges.(k).target = target && test edges.(k) then k
      else from (k + 1)
    in
    from 0

  let path g before test i =
    let rec go i acc =
      match before g.distances i with
      | -1 -> acc
      | source -> go source ({ source; choice = choice g source i (test source i) } :: acc)
    in
    go i []

  let ancestors g =
    let rec before known = function
      | -1 -> known
      | i -> before (i :: known) (Distances.before_nearest g.distances i)
    in
    before []

  let shortest_path g i = path g Distances.before_nearest (fun _ _ _ -> true) i

  let earliest_path g i =
    let in_time source target e = Rat.equal (arrival g target) (Rat.add (arrival g source) (duration g e)) in
    path g Distances.before_earliest in_time i

  (** {2 Bounds} *)

  let beyond value = function None -> false | Some bound -> value > (bound : int)

  (* Which of the bounds on states themselves keeps a state from being expanded. *)
  let out_of_bounds g (limits : Limits.t) i =
    if beyond (depth g i) limits.depth then Some Depth
    else if match limits.time with None -> false | Some t -> Rat.compare (arrival g i) t > 0 then Some Time
    else if beyond (Distances.instant g.distances i) limits.instant then Some Instant
    else None

  type memory = { states : int; labels : int; edges : int }

  let memory g =
    {
      states = Tuples.bytes g.tuples;
      labels = Distances.bytes g.distances + Statuses.bytes g.statuses;
      edges = Option.fold ~none:0 ~some:Edge_store.bytes g.edges;
    }

  (** {2 Growing the graph} *)

  (* Hardly any exploration has numbers that are too long: which states have is asked only then. *)
  let too_long g limits tuple =
    Limits.too_long limits ~longest:(L.longest g.context) ~bits:(fun () -> L.bits g.context (tuple ()))

  let add g limits i label tuple =
    Distances.push g.distances label;
    Option.iter Edge_store.make_room g.edges;
    if too_long g limits tuple then leave_out g i Bits
    else begin
      mark g i Queued;
      Frontier.push g.frontier i (Distances.time g.distances label.arrival)
    end

  (* The label of the path to a state with a transition more. *)
  let after g i label =
    Distances.after g.distances i (if takes_time g label then Some (L.duration g.context label) else None)

  (* Better labels for the target of an edge; whether there were any, and whether it is reached earlier. *)
  let improve g i e =
    let known = depth g e.target in
    let nearer, is_earlier = Distances.improve g.distances e.target (after g i e.label) in
    (* An edge that leads deeper when it is found may not do so once a shorter path to its end is known. *)
    if nearer || ((not (takes_time g e.label)) && known <= depth g i) then g.turns <- true;
    (nearer || is_earlier, is_earlier)

  (* A state left out for its labels alone, and now within the bounds, is taken up again. *)
  let reconsider g limits visitor i =
    match status g i with
    | Unexpanded (Depth | Time | Instant | Stopped)
      when Option.is_none (out_of_bounds g limits i) && visitor.matters (arrival g i) ->
      mark g i Queued;
      Frontier.push g.frontier i (arrival g i)
    | Queued -> (match g.order with By_steps -> () | By_time -> Frontier.push g.frontier i (arrival g i))
    | Expanded | Unexpanded _ -> ()

  (* Passes better labels on through edges known already. *)
  let settle g limits visitor first =
    let work = Queue.create () and waiting = Hashtbl.create 16 in
    let enter i =
      reconsider g limits visitor i;
      if is_expanded g i && not (Hashtbl.mem waiting i) then begin
        Hashtbl.add waiting i ();
        Queue.push i work
      end
    in
    enter first;
    while not (Queue.is_empty work) do
      let i = Queue.pop work in
      Hashtbl.remove waiting i;
      let pass e =
        let better, is_earlier = improve g i e in
        if is_earlier then visitor.earlier g e.target;
        if better then enter e.target
      in
      Array.iter pass (edges g i)
    done

  let is_new g (s : Lts.step) = Tuples.find g.tuples ~near:g.near s.changes < 0

  (* Whether the targets that are new fit a number of them. *)
  let fits g room tuple (steps : Lts.step list) =
    List.compare_length_with steps room <= 0
    ||
    let fresh = Hashtbl.create 16 in
    let add (s : Lts.step) =
      if is_new g s then Hashtbl.replace fresh (Array.to_list (Tuples.apply s.changes tuple)) ()
    in
    List.iter add steps;
    Hashtbl.length fresh <= room

  (* The target of a transition, which may be new. *)
  let connect g limits i tuple n ({ label; changes } : Lts.step) =
    let known = size g in
    let id = Tuples.intern_prepared g.tuples n in
    if id = known then add g limits id (after g i label) (fun () -> Tuples.apply changes tuple);
    id

  (* Shows the visitor those that are new, in the order of their numbers from [first] on. *)
  let introduce g around visitor ~first tuple steps targets =
    let next = ref first in
    let show (s : Lts.step) id =
      if id = !next then begin
        incr next;
        Limits.within around (fun () -> visitor.found g id (Tuples.apply s.changes tuple))
      end
    in
    List.iter2 show steps targets

  (* Whether an edge to a known state changes nothing: it takes no time, and leads deeper by no shorter way. *)
  let is_plain g i label target =
    (not (takes_time g label))
    && Distances.arrival_number g.distances target = Distances.arrival_number g.distances i
    && depth g target = depth g i + 1

  let relax g limits visitor i e =
    if not (is_plain g i e.label e.target) then begin
      let better, is_earlier = improve g i e in
      if is_earlier then visitor.earlier g e.target;
      if better then settle g limits visitor e.target
    end

  let successors g tuple =
    match L.reduced g.context tuple with
    | Some steps when List.for_all (is_new g) steps -> Ok steps
    | Some _ | None -> L.successors g.context tuple

  (* Expands a state; or says what ends the exploration. *)
  let expand g (limits : Limits.t) around visitor i =
    Tuples.load g.tuples g.near i;
    let tuple = Tuples.slots g.near in
    match Limits.within around (fun () -> successors g tuple) with
    | Error fault ->
      leave_out g i (Fault fault);
      None
    | Ok steps when match limits.states with None -> false | Some n -> not (fits g (n - size g) tuple steps) ->
      Some States
    | Ok steps ->
      mark g i Expanded;
      List.iteri (fun n (s : Lts.step) -> Tuples.prepare g.tuples ~near:g.near s.changes n) steps;
      let count = List.length steps in
      Tuples.fetch g.tuples count;
      let first = size g in
      let targets = List.mapi (connect g limits i tuple) steps in
      g.transitions <- g.transitions + count;
      let edge (s : Lts.step) target = { label = s.label; target } in
      let keep store = Edge_store.set store i (List.map2 (fun (s : Lts.step) t -> (s.label, t)) steps targets) in
      Option.iter keep g.edges;
      introduce g around visitor ~first tuple steps targets;
      List.iter2 (fun s target -> relax g limits visitor i (edge s target)) steps targets;
      let edges () = Array.of_list (List.map2 edge steps targets) in
      Option.iter (fun opened -> Limits.within around (fun () -> opened g i tuple (edges ()))) visitor.opened;
      None

  (* All that is left of the frontier, of which [i] has been taken already. *)
  let give_up g i reason =
    let leave i = match status g i with Queued -> leave_out g i reason | Expanded | Unexpanded _ -> () in
    leave i; Frontier.iter leave g.frontier

  let empty context order keep_edges =
    let tuples = Tuples.create ~width:(L.width context) in
    {
      context; order; tuples;
      near = Tuples.spread tuples;
      reader = Tuples.spread tuples;
      distances = Distances.create ();
      statuses = Statuses.create ();
      frontier = (match order with By_steps -> Frontier.by_steps () | By_time -> Frontier.by_time ());
      edges = (if keep_edges then Some (Edge_store.create ()) else None);
      transitions = 0;
      turns = false;
      timed = Timed_labels.create ();
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
  let visit g limits around visitor i =
    match (status g i, out_of_bounds g limits i) with
    | (Expanded | Unexpanded _), _ -> None
    | Queued, Some reason ->
      leave_out g i reason;
      None
    | Queued, None when not (visitor.matters (arrival g i)) ->
      leave_out g i Stopped;
      None
    | Queued, None -> expand g limits around visitor i

  let run ?(visitor = blind) ?(order = By_steps) ?(keep_edges = true) (limits : Limits.t)
      (around : Limits.surroundings) context =
    let g = empty context order keep_edges in
    let first = L.initial context in
    let i = Tuples.intern g.tuples ~near:g.near (Tuples.difference (Array.map (fun _ -> -1) first) first) in
    (* What ends the exploration, at this state or before it. *)
    let look round i =
      if visitor.enough () then Some Stopped
      else
        match around.stop () with
        | Some stop -> Some (Statuses.of_stop stop)
        | None -> (
            if round land 255 = 0 then around.progress (progress g i);
            match visit g limits around visitor i with
            | reason -> reason
            | exception Limits.Over stop ->
              (* It may have been expanded, but not looked at to the end. *)
              mark g i Queued;
              Some (Statuses.of_stop stop))
    in
    let rec loop round =
      match Frontier.take g.frontier with
      | None -> ()
      | Some i -> (
          match look round i with
          | Some reason -> give_up g i reason
          | None -> loop (round + 1))
    in
    add g limits i Distances.origin (fun () -> first);
    (match Limits.within around (fun () -> visitor.found g i first) with
     | () -> loop 0
     | exception Limits.Over stop -> give_up g i (Statuses.of_stop stop));
    g
end
