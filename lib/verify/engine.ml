open Scc_exact
open Scc_explore

module Make (L : Lts.S) = struct
  module Graph = Explore.Make (L)

  type operator = Reach | Inevitable

  type question = {
    operator : operator;
    within : Rat.t option;
    at : L.state -> Truth.t;
    along : L.state -> Timeline.extent -> Truth.t Timeline.t;
  }

  type finish =
    | At_state
    | During of { choice : int option; moment : Timeline.moment; sample : Algebraic.t }
    | Rests
    | Stops
    | Repeats of int
    | Passes of int option

  type trace = { steps : Graph.step list; last : int; finish : finish }

  type doubt =
    | Truncated of L.fault Explore.reason
    | Undefined of string
    | Zeno of trace

  type answer = Yes of trace option | No of trace option | Unknown of doubt list

  type result = { graph : Graph.t; answers : answer list; zeno : trace option }

  (** {2 What is known of a goal at each state}

      Of the timelines only the first moments are kept: at which the goal holds for certain, and at which
      it holds or cannot be decided. *)

  type phases = {
    surely : Timeline.moment option;
    perhaps : Timeline.moment option;
    why : string option;  (** of what cannot be decided *)
  }

  let never = { surely = None; perhaps = None; why = None }

  (* What follows a state. *)
  type ahead =
    | Unknown_yet
    | Edges of phases array
    | Ray of phases
    | Nothing

  type label = { at : Truth.t; mutable ahead : ahead }

  type monitor = {
    question : question;
    labels : label Growable.t;
    mutable met : (int * int option * Timeline.moment option) option;
    (** [Reach]: a state, and the choice and moment after it, where the goal holds *)
    mutable settled : answer option;  (** [Inevitable] *)
    mutable doubtful : bool;  (** the goal could not be decided somewhere *)
    mutable next_look : int;  (** [Inevitable]: the number of states at which to look again *)
  }

  let phases timeline =
    let is_true = function Truth.True -> true | _ -> false in
    let not_false = function Truth.False -> false | _ -> true in
    let perhaps = Timeline.first_after_start not_false timeline in
    let why =
      Option.bind perhaps (fun m ->
          match Timeline.at timeline (Timeline.sample timeline m) with
          | Truth.Undecided reason -> Some reason
          | _ -> None)
    in
    let surely =
      match why with None -> perhaps | Some _ -> Timeline.first_after_start is_true timeline
    in
    { surely; perhaps; why }

  let label m i = Growable.get m.labels i

  let judge m extent state =
    let p = phases (m.question.along state extent) in
    if Option.is_some p.why then m.doubtful <- true;
    p

  let label_edges m g i =
    let state = Graph.state g i in
    let edge (e : Graph.edge) =
      let d = L.duration e.transition in
      if Rat.sign d > 0 then judge m (Timeline.Lasts d) state else never
    in
    Array.map edge (Graph.edges g i)

  let open_label ~rests m g i =
    (label m i).ahead <-
      (if Array.length (Graph.edges g i) > 0 then Edges (label_edges m g i)
       else
         let state = Graph.state g i in
         if rests state then Ray (judge m Timeline.Forever state) else Nothing)

  (** {2 Reach} *)

  (* Whether a moment after the arrival in a state counts. *)
  let in_time m g i (moment : Timeline.moment) =
    match m.question.within with
    | None -> true
    | Some bound ->
      let c = Algebraic.compare_rat moment.offset (Rat.sub bound (Graph.arrival g i)) in
      if moment.attained then c <= 0 else c < 0

  let arrives_in_time m g i =
    match m.question.within with
    | None -> true
    | Some bound -> Rat.compare (Graph.arrival g i) bound <= 0

  (* The first choice of a state, or its ray, after which the chosen moment exists and counts. *)
  let ahead_of m g i choose =
    let counts p = match choose p with Some t when in_time m g i t -> Some t | _ -> None in
    match (label m i).ahead with
    | Unknown_yet | Nothing -> None
    | Ray p -> Option.map (fun t -> (None, t)) (counts p)
    | Edges list ->
      let rec go k =
        if k = Array.length list then None
        else match counts list.(k) with Some t -> Some (Some k, t) | None -> go (k + 1)
      in
      go 0

  let look_at_state m g i =
    match (label m i).at with
    | True when arrives_in_time m g i -> m.met <- Some (i, None, None)
    | True | False | Undecided _ -> ()

  let look_ahead m g i =
    match ahead_of m g i (fun p -> p.surely) with
    | Some (choice, moment) -> m.met <- Some (i, choice, Some moment)
    | None -> ()

  let watch_reach m g (event : Graph.event) =
    if Option.is_none m.met then
      match event with
      | Found i -> look_at_state m g i
      | Opened i -> look_ahead m g i
      | Earlier i ->
        look_at_state m g i;
        if Option.is_none m.met then look_ahead m g i

  let path_for m g i =
    match m.question.within with
    | None -> Graph.shortest_path g i
    | Some _ -> Graph.earliest_path g i

  let extent_of g i = function
    | None -> Timeline.Forever
    | Some k -> Timeline.Lasts (L.duration (Graph.edges g i).(k).transition)

  (* The sample of an open piece that goes on beyond the bound may have to be taken earlier. *)
  let before_bound m g i (moment : Timeline.moment) sample =
    match m.question.within with
    | None -> sample
    | Some bound ->
      let left = Rat.sub bound (Graph.arrival g i) in
      if Algebraic.compare_rat sample left <= 0 then sample
      else Algebraic.of_rat (Algebraic.between moment.offset (Algebraic.of_rat left))

  let trace_to m g (i, choice, moment) =
    let finish =
      match moment with
      | None -> At_state
      | Some moment ->
        let timeline = m.question.along (Graph.state g i) (extent_of g i choice) in
        let sample = Timeline.sample timeline moment in
        During { choice; moment; sample = before_bound m g i moment sample }
    in
    { steps = path_for m g i; last = i; finish }

  (** {2 Doubts} *)

  let same_reason (a : L.fault Explore.reason) (b : L.fault Explore.reason) =
    match (a, b) with
    | Depth, Depth | Time, Time | Instant, Instant | States, States | Seconds, Seconds
    | Memory, Memory | Interrupted, Interrupted | Stopped, Stopped | Fault _, Fault _ -> true
    | (Depth | Time | Instant | States | Seconds | Memory | Interrupted | Stopped | Fault _), _ -> false

  (* Each kind once, in the order of states. *)
  let truncations reasons =
    List.fold_left
      (fun kept r -> if List.exists (same_reason r) kept then kept else r :: kept)
      [] reasons
    |> List.rev_map (fun r -> Truncated r)

  let undefined_at m g i =
    let state_reason =
      match (label m i).at with
      | Undecided reason when arrives_in_time m g i -> Some reason
      | _ -> None
    in
    match state_reason with
    | Some _ -> state_reason
    | None -> (
        let unsure p = match p.why with Some _ -> p.perhaps | None -> None in
        match (ahead_of m g i unsure, (label m i).ahead) with
        | Some (None, _), Ray p -> p.why
        | Some (Some k, _), Edges list -> list.(k).why
        | _ -> None)

  let first_undefined m g =
    let rec go i =
      if i = Graph.size g then None
      else match undefined_at m g i with Some reason -> Some (Undefined reason) | None -> go (i + 1)
    in
    if m.doubtful then go 0 else None

  let answer_reach m g =
    match m.met with
    | Some place -> Yes (Some (trace_to m g place))
    | None -> (
        let relevant = List.filter (fun (i, _) -> arrives_in_time m g i) (Graph.unexpanded g) in
        match Option.to_list (first_undefined m g) @ truncations (List.map snd relevant) with
        | [] -> No None
        | doubts -> Unknown doubts)

  (** {2 Inevitable} *)

  (* The graph with what cannot be decided taken as true ([generous]) or as false. *)
  let abstract m g ~generous : Inevitable.graph =
    let choose p = if generous then p.perhaps else p.surely in
    let holds i =
      match (label m i).at with True -> true | False -> false | Undecided _ -> generous
    in
    let node i : Inevitable.node =
      match (label m i).ahead with
      | Unknown_yet -> Unexplored
      | Nothing -> Dead_end
      | Ray p -> Ray (choose p)
      | Edges list ->
        Arcs
          (Array.mapi
             (fun k (e : Graph.edge) : Inevitable.arc ->
                { target = e.target; duration = L.duration e.transition; first = choose list.(k) })
             (Graph.edges g i))
    in
    { size = Graph.size g; holds; node }

  let trace_of (t : Inevitable.trace) =
    let finish =
      match t.finish with
      | Rests -> Rests
      | Stops -> Stops
      | Repeats k -> Repeats k
      | Passes choice -> Passes choice
    in
    let steps = List.map (fun (source, choice) -> { Graph.source; choice }) t.steps in
    { steps; last = t.last; finish }

  let reasons_of g nodes =
    List.filter_map
      (fun i -> match Graph.status g i with Graph.Unexpanded r -> Some r | Expanded | Queued -> None)
      nodes

  (* [None] while it depends on states that are still queued. *)
  let answer_inevitable m g =
    let within = m.question.within in
    let search generous = Inevitable.search (abstract m g ~generous) ~within in
    let sure = search m.doubtful in
    match sure.avoided with
    | Some trace -> Some (No (Some (trace_of trace)))
    | None ->
      let o = if m.doubtful then search false else sure in
      let queued i = match Graph.status g i with Graph.Queued -> true | Expanded | Unexpanded _ -> false in
      if List.exists queued o.unexplored then None
      else
        let unclear = Undefined "the goal cannot be decided where it matters" in
        let undefined =
          if Option.is_none o.avoided then None
          else Some (Option.value ~default:unclear (first_undefined m g))
        in
        let zeno = Option.map (fun t -> Zeno (trace_of t)) o.zeno in
        Some
          (match
             Option.to_list undefined @ Option.to_list zeno @ truncations (reasons_of g o.unexplored)
           with
           | [] -> Yes None
           | doubts -> Unknown doubts)

  (* Looking costs time in proportion to the graph: it is done each time that the graph has doubled. An
     answer that depends on nothing unexpanded stays. *)
  let watch_inevitable m g =
    if Option.is_none m.settled && Graph.size g >= m.next_look then begin
      m.next_look <- 2 * Graph.size g;
      match answer_inevitable m g with
      | Some (Yes _ | No _) as settled -> m.settled <- settled
      | Some (Unknown _) | None -> ()
    end

  let answer m g =
    match (m.question.operator, m.settled) with
    | Reach, _ -> answer_reach m g
    | Inevitable, Some settled -> settled
    | Inevitable, None -> (
        match answer_inevitable m g with
        | Some a -> a
        | None -> Scc_base.Bug.fail __POS__ "states are queued after the end of the exploration")

  (** {2 All together} *)

  let decided m =
    match m.question.operator with
    | Reach -> Option.is_some m.met
    | Inevitable -> Option.is_some m.settled

  let watch ~rests m g (event : Graph.event) =
    if not (decided m) then begin
      (match event with
       | Found i ->
         let at = m.question.at (Graph.state g i) in
         (match at with Undecided _ -> m.doubtful <- true | True | False -> ());
         Growable.push m.labels { at; ahead = Unknown_yet }
       | Opened i -> open_label ~rests m g i
       | Earlier _ -> ());
      match m.question.operator with
      | Reach -> watch_reach m g event
      | Inevitable -> ( match event with Opened _ -> watch_inevitable m g | Found _ | Earlier _ -> ())
    end

  let monitor question =
    { question; labels = Growable.create (); met = None; settled = None; doubtful = false; next_look = 16 }

  let greatest_bound questions =
    let join acc q =
      match (acc, q.within) with Some a, Some b -> Some (Rat.max a b) | _ -> None
    in
    match questions with [] -> None | q :: rest -> List.fold_left join q.within rest

  let horizon (limits : Limits.t) questions =
    match (limits.time, greatest_bound questions) with
    | Some a, Some b -> Some (Rat.min a b)
    | Some a, None | None, Some a -> Some a
    | None, None -> None

  (* A cycle of the whole graph along which no time passes. *)
  let zeno_cycle g =
    let arcs i =
      Array.to_list (Array.mapi (fun k (e : Graph.edge) -> (k, e)) (Graph.edges g i))
      |> List.filter (fun (_, (e : Graph.edge)) -> Rat.sign (L.duration e.transition) = 0)
      |> List.map (fun (k, (e : Graph.edge)) -> (e.target, k))
    in
    let size = Graph.size g in
    let components =
      Components.compute ~size
        ~roots:(List.init size (fun i -> i))
        ~successors:(fun i -> List.map fst (arcs i))
    in
    let inside i (j, _) = Int.equal components.number.(i) components.number.(j) in
    let cycle i =
      Option.map
        (fun (j, choice) ->
           let successors u = List.filter (inside u) (arcs u) in
           match Components.path ~successors ~from:j ~goal:(Int.equal i) with
           | None -> Scc_base.Bug.fail __POS__ "a component is not connected"
           | Some back ->
             let steps = List.map (fun (source, choice) -> { Graph.source; choice }) in
             let stem = Graph.shortest_path g i in
             {
               steps = stem @ ({ Graph.source = i; choice } :: steps back);
               last = i;
               finish = Repeats (List.length stem);
             })
        (List.find_opt (inside i) (arcs i))
    in
    let rec go i =
      if i = size then None else match cycle i with Some t -> Some t | None -> go (i + 1)
    in
    go 0

  let run ?(observe = fun _ _ -> ()) ~rests limits around context questions =
    let monitors = List.map monitor questions in
    let visit g event =
      observe g event;
      List.iter (fun m -> watch ~rests m g event) monitors;
      match monitors with
      | [] -> Graph.Continue
      | _ :: _ -> if List.for_all decided monitors then Graph.Stop else Graph.Continue
    in
    let limits = { limits with Limits.time = horizon limits questions } in
    let graph = Graph.run ~visit limits around context in
    { graph; answers = List.map (fun m -> answer m graph) monitors; zeno = zeno_cycle graph }
end
