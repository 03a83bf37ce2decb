open Scc_exact
open Scc_explore

type predicate = {
  at : int array -> Truth.t;
  along : (int array -> Timeline.extent -> Truth.t Timeline.t) option;
}

module Make (L : Lts.S) = struct
  module Graph = Explore.Make (L)

  type operator = Reach | Inevitable

  type question = { operator : operator; within : Rat.t option; goal : predicate }

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
    | Edges of Graph.edge array * phases array
    | Ray of phases
    | Nothing

  type label = { at : Truth.t; ahead : ahead }

  type monitor = {
    question : question;
    rests : int array -> bool;
    labels : label Growable.t;  (** [Inevitable]: of the states looked at so far *)
    mutable met : (int * int option * Timeline.moment option) option;
    (** [Reach]: a state, and the choice and moment after it, where the goal holds *)
    mutable settled : answer option;  (** [Inevitable] *)
    mutable doubtful : int list;  (** states where, or after which, the goal could not be decided *)
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

  let along m tuple extent =
    match m.question.goal.along with
    | Some along -> along tuple extent
    | None -> Timeline.constant extent (m.question.goal.at tuple)

  let ahead_of_state m g tuple edges =
    let edge (e : Graph.edge) =
      let d = Graph.duration g e in
      if Rat.sign d > 0 then phases (along m tuple (Timeline.Lasts d)) else never
    in
    if Array.length edges > 0 then Edges (edges, Array.map edge edges)
    else if m.rests tuple then Ray (phases (along m tuple Timeline.Forever))
    else Nothing

  (* What holds in a state and after it. *)
  let judge m g i =
    let tuple = Graph.tuple g i in
    let ahead =
      match Graph.status g i with
      | Graph.Expanded -> ahead_of_state m g tuple (Graph.edges g i)
      | Queued | Unexpanded _ -> Unknown_yet
    in
    { at = m.question.goal.at tuple; ahead }

  let undecided = function Truth.Undecided _ -> true | True | False -> false

  let doubts_of ahead =
    let unsure p = Option.is_some p.why in
    match ahead with
    | Unknown_yet | Nothing -> false
    | Ray p -> unsure p
    | Edges (_, list) -> Array.exists unsure list

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
  let find_ahead m g i ahead choose =
    let counts p = match choose p with Some t when in_time m g i t -> Some t | _ -> None in
    match ahead with
    | Unknown_yet | Nothing -> None
    | Ray p -> Option.map (fun t -> (None, t)) (counts p)
    | Edges (_, list) ->
      let rec go k =
        if k = Array.length list then None
        else match counts list.(k) with Some t -> Some (Some k, t) | None -> go (k + 1)
      in
      go 0

  let look_at_state m g i truth =
    match truth with
    | Truth.True when arrives_in_time m g i -> m.met <- Some (i, None, None)
    | True | False | Undecided _ -> ()

  let look_ahead m g i ahead =
    match find_ahead m g i ahead (fun p -> p.surely) with
    | Some (choice, moment) -> m.met <- Some (i, choice, Some moment)
    | None -> ()

  let doubt m i = m.doubtful <- i :: m.doubtful

  let found_reach m g i tuple =
    if Option.is_none m.met then begin
      let truth = m.question.goal.at tuple in
      if undecided truth then doubt m i;
      look_at_state m g i truth
    end

  (* A goal that does not change along a trajectory has been looked at where that starts. *)
  let opened_reach m g i tuple edges =
    if Option.is_none m.met && Option.is_some m.question.goal.along then begin
      let ahead = ahead_of_state m g tuple edges in
      if doubts_of ahead then doubt m i;
      look_ahead m g i ahead
    end

  let earlier_reach m g i =
    if Option.is_none m.met && Option.is_some m.question.within then begin
      let { at; ahead } = judge m g i in
      look_at_state m g i at;
      if Option.is_none m.met then look_ahead m g i ahead
    end

  let path_for m g i =
    match m.question.within with
    | None -> Graph.shortest_path g i
    | Some _ -> Graph.earliest_path g i

  let extent_of g i = function
    | None -> Timeline.Forever
    | Some k -> Timeline.Lasts (Graph.duration g (Graph.edges g i).(k))

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
        let timeline = along m (Graph.tuple g i) (extent_of g i choice) in
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
    let { at; ahead } = judge m g i in
    let state_reason =
      match at with
      | Undecided reason when arrives_in_time m g i -> Some reason
      | _ -> None
    in
    match state_reason with
    | Some _ -> state_reason
    | None -> (
        let unsure p = match p.why with Some _ -> p.perhaps | None -> None in
        match (find_ahead m g i ahead unsure, ahead) with
        | Some (None, _), Ray p -> p.why
        | Some (Some k, _), Edges (_, list) -> list.(k).why
        | _ -> None)

  let first_undefined m g =
    List.find_map
      (fun i -> Option.map (fun reason -> Undefined reason) (undefined_at m g i))
      (List.sort_uniq Int.compare m.doubtful)

  let answer_reach m g =
    match m.met with
    | Some place -> Yes (Some (trace_to m g place))
    | None -> (
        let relevant = List.filter (fun (i, _) -> arrives_in_time m g i) (Graph.unexpanded g) in
        match Option.to_list (first_undefined m g) @ truncations (List.rev (List.rev_map snd relevant)) with
        | [] -> No None
        | doubts -> Unknown doubts)

  (** {2 Inevitable} *)

  (* A state that was expanded since it was looked at is looked at again. *)
  let update m g =
    let fresh = Growable.length m.labels in
    for i = 0 to Graph.size g - 1 do
      if i >= fresh then Growable.push m.labels (judge m g i)
      else
        match ((Growable.get m.labels i).ahead, Graph.status g i) with
        | Unknown_yet, Graph.Expanded -> Growable.set m.labels i (judge m g i)
        | (Unknown_yet | Edges _ | Ray _ | Nothing), _ -> ()
    done;
    m.doubtful <- [];
    for i = Graph.size g - 1 downto 0 do
      let l = Growable.get m.labels i in
      if undecided l.at || doubts_of l.ahead then doubt m i
    done

  (* The graph with what cannot be decided taken as true ([generous]) or as false. *)
  let abstract m g ~generous : Inevitable.graph =
    let choose p = if generous then p.perhaps else p.surely in
    let holds i =
      match (Growable.get m.labels i).at with True -> true | False -> false | Undecided _ -> generous
    in
    let node i : Inevitable.node =
      match (Growable.get m.labels i).ahead with
      | Unknown_yet -> Unexplored
      | Nothing -> Dead_end
      | Ray p -> Ray (choose p)
      | Edges (edges, list) ->
        Arcs
          (Array.mapi
             (fun k (e : Graph.edge) : Inevitable.arc ->
                { target = e.target; duration = Graph.duration g e; first = choose list.(k) })
             edges)
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
    update m g;
    let within = m.question.within in
    let doubtful = List.length m.doubtful > 0 in
    let search generous = Inevitable.search (abstract m g ~generous) ~within in
    let sure = search doubtful in
    match sure.avoided with
    | Some trace -> Some (No (Some (trace_of trace)))
    | None ->
      let o = if doubtful then search false else sure in
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

  let is_reach m = match m.question.operator with Reach -> true | Inevitable -> false

  let monitor rests question =
    {
      question; rests;
      labels = Growable.create ();
      met = None; settled = None; doubtful = []; next_look = 16;
    }

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
  let find_zeno_cycle g =
    let arcs i =
      Array.to_list (Array.mapi (fun k (e : Graph.edge) -> (k, e)) (Graph.edges g i))
      |> List.filter (fun (_, e) -> Rat.sign (Graph.duration g e) = 0)
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

  let zeno_cycle g = if Graph.turns g then find_zeno_cycle g else None

  let visitor observe monitors : Graph.visitor =
    let reach, inevitable = List.partition is_reach monitors in
    {
      found =
        (fun g i tuple ->
           observe g i tuple;
           List.iter (fun m -> found_reach m g i tuple) reach);
      opened =
        (fun g i tuple edges ->
           List.iter (fun m -> opened_reach m g i tuple edges) reach;
           List.iter (fun m -> watch_inevitable m g) inevitable);
      earlier = (fun g i -> List.iter (fun m -> earlier_reach m g i) reach);
      enough = (fun () -> match monitors with [] -> false | _ :: _ -> List.for_all decided monitors);
    }

  let run ?(observe = fun _ _ _ -> ()) ?keep_edges ~rests limits around context questions =
    let monitors = List.map (monitor rests) questions in
    let limits = { limits with Limits.time = horizon limits questions } in
    let graph = Graph.run ~visitor:(visitor observe monitors) ?keep_edges limits around context in
    { graph; answers = List.map (fun m -> answer m graph) monitors; zeno = zeno_cycle graph }
end
