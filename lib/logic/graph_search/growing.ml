open Scc_data
open Scc_exact
open Statuses

module Make (L : Lts.S) = struct
  include Ahead.Make (L)

  type arrow = New of Lts.step | Known of edge
  type steps = { steps : Lts.step list; reduced : bool }
  type noted = { arrows : arrow list; count : int; reduced : bool }
  type expansion = Found of steps | Noted of noted

  type visitor = {
    found : t -> int -> int array -> unit;
    opened : (t -> int -> int array -> edge array -> unit) option;
    earlier : t -> int -> unit;
    enough : unit -> bool;
    matters : Rat.t -> bool;
    dull : int array -> bool;
  }

  let blind =
    {
      matters = (fun _ -> true);
      dull = (fun _ -> false);
      found = (fun _ _ _ -> ());
      opened = None;
      earlier = (fun _ _ -> ());
      enough = (fun () -> false);
    }

  type told = { asks : int -> bool; tell : int -> noted -> unit }

  type answer = { words : Ahead.words; at : int }

  type expander = {
    ready : int -> answer option;
    expand : int -> int array -> (expansion, L.fault) result;
    expanded : unit -> told option;
    finish : unit -> unit;
  }

  (** {2 Bounds} *)

  let beyond value = function None -> false | Some bound -> value > (bound : int)

  (* Which of the bounds on states themselves keeps a state from being expanded. *)
  let out_of_bounds g (limits : Limits.t) i =
    if beyond (depth g i) limits.depth then Some Depth
    else if match limits.time with None -> false | Some t -> Rat.compare (arrival g i) t > 0 then Some Time
    else if beyond (Distances.instant g.distances i) limits.instant then Some Instant
    else None

  (** {2 Growing the graph} *)

  let mark g i status = Statuses.set g.statuses i status
  let leave_out g i reason = mark g i (Unexpanded reason)

  (* Hardly any exploration has numbers that are too long: which states have is asked only then. *)
  let too_long g limits tuple =
    Limits.too_long limits ~longest:(L.longest g.context) ~bits:(fun () -> L.bits g.context (tuple ()))

  (* What other processes know of the state. *)
  let share_label g i =
    let put s = Shared_states.put s i ~depth:(depth g i) ~arrival:(Distances.arrival_number g.distances i) in
    Option.iter put g.shared

  let add g limits i label tuple =
    Distances.push g.distances label;
    share_label g i;
    Option.iter Edge_store.make_room g.edges;
    if too_long g limits tuple then leave_out g i Bits
    else begin
      mark g i Queued;
      Frontier.push g.frontier i (Distances.time g.distances label.arrival)
    end

  (* The label of the path to a state with a transition more. *)
  let after g i label =
    let duration = if takes_time g label then Some (L.duration g.context label) else None in
    Distances.after g.distances i ~transitions:(transitions_of g label) duration

  (* All states of a cycle without duration have one earliest arrival. When one of these changes, all edges of its
     state are looked at again. *)
  let are_reached_together g i j = Distances.arrival_number g.distances i = Distances.arrival_number g.distances j

  let note_turning g target =
    match g.turning with
    | At targets ->
      Int_vector.push targets target;
      Option.iter Shared_states.note_turn g.shared
    | Anywhere -> ()

  (* Better labels for the target of an edge; whether there were any, and whether it is reached earlier. *)
  let improve g i e =
    let known = depth g e.target in
    let nearer, is_earlier = Distances.improve g.distances e.target (after g i e.label) in
    (* An edge that leads deeper when it is found may not do so once a shorter path to its end is known. *)
    if nearer || is_earlier then begin
      share_label g e.target;
      Option.iter Shared_states.improved g.shared
    end;
    if nearer then begin
      g.turning <- Anywhere;
      Option.iter Shared_states.note_turn g.shared
    end
    else if (not (takes_time g e.label)) && known <= depth g i && are_reached_together g i e.target then
      note_turning g e.target;
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

  (* An edge to a known state that clearly changes nothing leads deeper by no shorter way, and not earlier. No way
     that goes on from a state leads to it sooner: of all of its edges, its own depth and arrival are the same. *)
  let[@inline] is_plain g ~deeper ~arrival label target =
    Distances.arrival_number g.distances target = arrival
    &&
    let known = depth g target in
    known = deeper || (known < deeper && takes_time g label)

  (* An edge that may change something for its target. *)
  let relax g limits visitor i label target =
    let better, is_earlier = improve g i { label; target } in
    if is_earlier then visitor.earlier g target;
    if better then settle g limits visitor target

  (* Whether it may have changed something. *)
  let relax_unless_plain g limits visitor i label target =
    let arrival = Distances.arrival_number g.distances i in
    let matters = not (is_plain g ~deeper:(depth g i + transitions_of g label) ~arrival label target) in
    if matters then relax g limits visitor i label target;
    matters

  (* A search for cycles asks again for the edges without duration of many states, once there may be one. *)
  let remember_at_once (g : t) i count =
    if may_turn g && Option.is_none g.edges then
      Edges_at_once.keep g.at_once i (fun put ->
          for n = 0 to count - 1 do
            if not (takes_time g g.labels.(n)) then put n g.targets.(n)
          done)
end
