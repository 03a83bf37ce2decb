open Scc_data

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
  include Linked.Make (L)

  let is_new g (s : Lts.step) = Tuples.find g.tuples ~near:g.near s.changes < 0

  (* Whether the targets that are new, of so many transitions, fit a number of them. *)
  let fits g room (steps : Lts.step list) count =
    count <= room
    ||
    let fresh = Hashtbl.create 16 in
    let add (s : Lts.step) = Hashtbl.replace fresh (Tuples.key g.tuples ~near:g.near s.changes) () in
    List.iter add (List.filter (is_new g) steps);
    Hashtbl.length fresh <= room

  (* The target of a transition, which may be new; [known] states were there before it was looked up. *)
  let connect g limits i tuple ~known id ({ label; changes } : Lts.step) =
    if id = known then begin
      L.entered g.context changes;
      add g limits id (after g i label) (fun () -> Tuples.apply changes tuple)
    end

  let intern_prepared g limits i tuple n step =
    let known = size g in
    let id = Tuples.intern_prepared g.tuples n in
    connect g limits i tuple ~known id step;
    id

  (* Shows the visitor those that are new, in the order of their numbers from [first] on. *)
  let introduce g around visitor ~first tuple steps =
    let rec show next n = function
      | [] -> ()
      | (s : Lts.step) :: rest ->
        if Array.unsafe_get g.targets n = next then begin
          visitor.found g next (Tuples.apply s.changes tuple);
          show (next + 1) (n + 1) rest
        end
        else show next (n + 1) rest
    in
    if size g > first then Limits.within around (fun () -> show first 0 steps)

  let all_or_some g ~some ~all =
    match some with
    | Some steps when List.exists (is_ahead g) steps -> Ok { steps; reduced = true }
    | Some _ | None -> Result.map (fun steps -> { steps; reduced = false }) (all ())

  let successors g tuple =
    all_or_some g ~some:(L.reduced g.context tuple) ~all:(fun () -> L.successors g.context tuple)

  (* Finds the targets of the steps of a state that has just been loaded, and makes those that are new. *)
  let look_up g limits i tuple steps count () =
    let rec prepare prepared = function
      | [] -> prepared
      | { Lts.changes = [||]; _ } :: rest -> prepare prepared rest
      | s :: rest ->
        Tuples.prepare g.tuples ~near:g.near ~lasting:(not (takes_time g s.label)) s.changes prepared;
        prepare (prepared + 1) rest
    in
    Tuples.begin_round g.tuples ~near:g.near count;
    Tuples.fetch g.tuples (prepare 0 steps);
    let rec find n k = function
      | [] -> ()
      | { Lts.changes = [||]; _ } :: rest ->
        Array.unsafe_set g.targets n i;
        find (n + 1) k rest
      | s :: rest ->
        let known = Tuples.prepared g.tuples k in
        Array.unsafe_set g.targets n (if known >= 0 then known else intern_prepared g limits i tuple k s);
        find (n + 1) (k + 1) rest
    in
    find 0 0 steps

  let not_as_noted () = Scc_base.Bug.fail __POS__ "an expansion is not what it was when it was noted"

  (* The same of what was noted of them. *)
  let look_up_noted g limits i tuple arrows () =
    let target = function
      | Known { target; _ } -> if target < size g then target else not_as_noted ()
      | New s ->
        let known = size g in
        let id = Tuples.intern g.tuples ~near:g.near s.changes in
        if id <> known then not_as_noted ();
        connect g limits i tuple ~known id s;
        id
    in
    List.iteri (fun n arrow -> g.targets.(n) <- target arrow) arrows

  let without_target = function New s -> s | Known { label; _ } -> { Lts.label; changes = [||] }

  let labels_of steps = Array.of_list (List.map (fun (s : Lts.step) -> s.label) steps)

  (* Relaxes the edges of a state; and what is told of them. The first one to a state that is new makes it;
     others from the same state find it there. *)
  let relax_all g limits visitor i ~first steps told =
    let arrival = Distances.arrival_number g.distances i in
    let rec each n next arrows = function
      | [] -> List.rev arrows
      | (s : Lts.step) :: rest ->
        let target = Array.unsafe_get g.targets n in
        let matters = not (is_plain g ~deeper:(depth g i + transitions_of g s.label) ~arrival s.label target) in
        if matters then relax g limits visitor i s.label target;
        match told with
        | None -> each (n + 1) next arrows rest
        | Some _ when target = next -> each (n + 1) (next + 1) (New s :: arrows) rest
        | Some t when matters || t.asks s.label ->
          each (n + 1) next (Known { label = s.label; target } :: arrows) rest
        | Some _ -> each (n + 1) next arrows rest
    in
    each 0 first [] steps

  (* Expands a state; or says what ends the exploration. *)
  let expand_here g (limits : Limits.t) around visitor expander i =
    Tuples.load g.tuples g.near i;
    let tuple = Tuples.slots g.near in
    (* There are [count] transitions, these steps among them, whose targets [look_up] finds. *)
    let grow ({ steps; reduced } : steps) ~look_up ~length ~count ~all_told =
      match limits.states with
      | Some n when not (fits g (n - size g) steps length) -> Some States
      | Some _ | None ->
        mark g i Expanded;
        if reduced then Statuses.note_reduced g.statuses i;
        let first = size g in
        make_room_for_targets g length;
        look_up ();
        let targets () = Array.sub g.targets 0 length in
        g.transitions <- g.transitions + count;
        Option.iter (fun store -> Edge_store.set store i ~labels:(labels_of steps) ~targets:(targets ())) g.edges;
        introduce g around visitor ~first tuple steps;
        let told = expander.expanded () in
        let arrows = relax_all g limits visitor i ~first steps told in
        if all_told && (not reduced) && List.for_all (fun (s : Lts.step) -> takes_time g s.label) steps then
          Statuses.note_timed g.statuses i
        else if all_told then begin
          List.iteri (fun n (s : Lts.step) -> g.labels.(n) <- s.label) steps;
          remember_at_once g i length
        end;
        let edges () = Array.map2 (fun label target -> { label; target }) (labels_of steps) (targets ()) in
        Option.iter (fun opened -> Limits.within around (fun () -> opened g i tuple (edges ()))) visitor.opened;
        Option.iter (fun t -> t.tell i { arrows; count; reduced }) told;
        None
    in
    match Limits.within around (fun () -> expander.expand i tuple) with
    | Error fault ->
      leave_out g i (Fault fault);
      None
    | Ok (Found ({ steps; _ } as found : steps)) ->
      let count = List.length steps in
      grow found ~look_up:(look_up g limits i tuple steps count) ~length:count ~count ~all_told:true
    | Ok (Noted { arrows; count; reduced }) ->
      let noted = { steps = List.map without_target arrows; reduced } in
      grow noted ~look_up:(look_up_noted g limits i tuple arrows) ~length:(List.length arrows) ~count
        ~all_told:false

  (* Only where others find steps it is asked whether they have. *)
  let expand g limits around visitor expander i =
    match g.shared with
    | None -> expand_here g limits around visitor expander i
    | Some s -> (
        match Limits.within around (fun () -> expander.ready i) with
        | None -> expand_here g limits around visitor expander i
        | Some answer -> (
            match choose g s i answer with
            | None -> expand_here g limits around visitor expander i
            | Some list -> grow_linked g limits around visitor expander.expanded i s answer list))

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
      at_once = Edges_at_once.create ();
      targets = [||];
      labels = [||];
      transitions = 0;
      turning = At (Int_vector.create ());
      timed = Timed_labels.create ~duration:(L.duration context) ~transitions:(L.transitions context);
      shared = None;
    }

  let progress g i : Limits.progress =
    Explored {
      states = size g;
      transitions = g.transitions;
      waiting = Frontier.length g.frontier;
      depth = depth g i;
      model_time = Lazy.from_val (Some (arrival g i));
    }

  (* Looks at a state that waited; or says what ends the exploration. *)
  let visit g limits around visitor expander i =
    match (status g i, out_of_bounds g limits i) with
    | (Expanded | Unexpanded _), _ -> None
    | Queued, Some reason ->
      leave_out g i reason;
      None
    | Queued, None when not (visitor.matters (arrival g i)) ->
      leave_out g i Stopped;
      None
    | Queued, None -> expand g limits around visitor expander i

  (* By steps, a state before one that has had its turn has been taken up again: it comes after later ones, while
     others go by the numbers. *)
  let waits g limits visitor furthest i =
    match (status g i, g.order) with
    | Queued, By_steps when i < !furthest -> false
    | Queued, _ -> Option.is_none (out_of_bounds g limits i) && visitor.matters (arrival g i)
    | (Expanded | Unexpanded _), _ -> false

  let room g (limits : Limits.t) () =
    match limits.states with None -> max_int | Some n -> Int.max 0 (n - size g)

  type expanding =
    t -> all_edges:bool -> waits:(int -> bool) -> room:(unit -> int) -> dull:(int array -> bool) -> expander

  let here g ~all_edges:_ ~waits:_ ~room:_ ~dull:_ =
    {
      ready = (fun _ -> None);
      expand = (fun _ tuple -> Result.map (fun found -> Found found) (successors g tuple));
      expanded = (fun () -> None);
      finish = Fun.id;
    }

  let run ?(visitor = blind) ?(order = By_steps) ?(keep_edges = true) ?(expanding = here) (limits : Limits.t)
      (around : Limits.surroundings) context =
    let g = empty context order keep_edges in
    let first = L.initial context in
    let whole = Tuples.difference (Array.map (fun _ -> -1) first) first in
    let i = Tuples.intern g.tuples ~near:g.near whole in
    let all_edges = keep_edges || Option.is_some visitor.opened in
    let furthest = ref (-1) in
    let waits = waits g limits visitor furthest and room = room g limits in
    let expander = expanding g ~all_edges ~waits ~room ~dull:visitor.dull in
    (* What ends the exploration, at this state or before it. *)
    let look round i =
      if visitor.enough () then Some Stopped
      else
        match around.stop () with
        | Some stop -> Some (Statuses.of_stop stop)
        | None -> (
            if round land 255 = 0 then around.progress (progress g i);
            match visit g limits around visitor expander i with
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
          furthest := Int.max !furthest i;
          match look round i with
          | Some reason -> give_up g i reason
          | None -> loop (round + 1))
    in
    let explore () =
      L.entered g.context whole;
      add g limits i Distances.origin (fun () -> first);
      match Limits.within around (fun () -> visitor.found g i first) with
      | () -> loop 0
      | exception Limits.Over stop -> give_up g i (Statuses.of_stop stop)
    in
    Fun.protect explore ~finally:expander.finish;
    g
end
