open Scc_data
open Scc_exact
open Scc_graph_search

type predicate = {
  at : int array -> Truth.t;
  along : (int array -> Timeline.extent -> Truth.t Timeline.t) option;
}

type phases = {
  surely : Timeline.moment option;
  perhaps : Timeline.moment option;
  why : string option;  (** of what cannot be decided *)
}

let never = { surely = None; perhaps = None; why = None }

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

let is_in_time within ~arrival (moment : Timeline.moment) =
  match within with
  | None -> true
  | Some bound ->
    let c = Algebraic.compare_rat moment.offset (Rat.sub bound arrival) in
    if moment.attained then c <= 0 else c < 0

let sample_in_time within ~arrival (moment : Timeline.moment) sample =
  match within with
  | None -> sample
  | Some bound ->
    let left = Rat.sub bound arrival in
    if Algebraic.compare_rat sample left <= 0 then sample
    else Algebraic.of_rat (Algebraic.between moment.offset (Algebraic.of_rat left))

module Make (L : Lts.S) (Graph : module type of Explore.Make (L)) = struct
  type question = { within : Rat.t option; goal : predicate }

  type finish =
    | At_state
    | During of { choice : int option; moment : Timeline.moment; sample : Algebraic.t }
    | Repeats of int

  type trace = { steps : Graph.step list; last : int; finish : finish }
  type doubts = { unexplored : int Seq.t; undefined : string option }
  type answer = Met of trace | Never | Open of doubts
  type result = { graph : Graph.t; answers : answer list; zeno : trace option }

  (** {2 What is known of a goal at each state} *)

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
    by_time : bool;  (** the earliest run is looked for, and not just any *)
    mutable met : (int * int option * Timeline.moment option) option;
    (** a state, and the choice and moment after it, where the goal holds *)
    mutable decided : bool;
    mutable doubtful : int list;  (** states where, or after which, the goal could not be decided *)
  }

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
      | Explore.Expanded -> ahead_of_state m g tuple (Graph.edges g i)
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

  (** {2 Meeting the goal} *)

  (* Whether a moment after the arrival in a state counts. *)
  let in_time m g i = is_in_time m.question.within ~arrival:(Graph.arrival g i)

  let arrives_in_time m g i =
    match m.question.within with
    | None -> true
    | Some bound -> Rat.compare (Graph.arrival g i) bound <= 0

  (* The choice of a state, or its ray, after which the chosen moment exists and counts; the earliest of them. *)
  let find_ahead m g i ahead choose =
    let counts p = match choose p with Some t when in_time m g i t -> Some t | _ -> None in
    match ahead with
    | Unknown_yet | Nothing -> None
    | Ray p -> Option.map (fun t -> (None, t)) (counts p)
    | Edges (_, list) ->
      let earlier best k p =
        match (counts p, best) with
        | Some t, Some (_, known) when Timeline.compare_moment known t <= 0 -> best
        | Some t, _ -> Some (Some k, t)
        | None, _ -> best
      in
      snd (Array.fold_left (fun (k, best) p -> (k + 1, earlier best k p)) (0, None) list)

  (* When, counted from the start of the run. *)
  let moment_of g (i, _, moment) : Timeline.moment =
    let { Timeline.offset; attained } =
      match moment with None -> { Timeline.offset = Algebraic.zero; attained = true } | Some m -> m
    in
    { offset = Algebraic.add_rat (Graph.arrival g i) offset; attained }

  (* With the order of time the first that is met need not be the earliest. *)
  let meet m g place =
    match m.met with
    | Some known when Timeline.compare_moment (moment_of g known) (moment_of g place) <= 0 -> ()
    | Some _ | None ->
      m.met <- Some place;
      if not m.by_time then m.decided <- true

  let look_at_state m g i truth =
    match truth with
    | Truth.True when arrives_in_time m g i -> meet m g (i, None, None)
    | True | False | Undecided _ -> ()

  let look_ahead m g i ahead =
    match find_ahead m g i ahead (fun p -> p.surely) with
    | Some (choice, moment) -> meet m g (i, choice, Some moment)
    | None -> ()

  (* Whatever is still to be expanded is reached no earlier than the state that is. *)
  let close m g i =
    match m.met with
    | None -> ()
    | Some place ->
      let { Timeline.offset; attained } = moment_of g place in
      let c = Algebraic.compare_rat offset (Graph.arrival g i) in
      if c < 0 || (c = 0 && attained) then m.decided <- true

  let doubt m i = m.doubtful <- i :: m.doubtful

  let found m g i tuple =
    if not m.decided then begin
      let truth = m.question.goal.at tuple in
      if undecided truth then doubt m i;
      look_at_state m g i truth
    end

  (* A goal that does not change along a trajectory has been looked at where that starts. *)
  let opened m g i tuple edges =
    if not m.decided then begin
      if Option.is_some m.question.goal.along then begin
        let ahead = ahead_of_state m g tuple edges in
        if doubts_of ahead then doubt m i;
        look_ahead m g i ahead
      end;
      if m.by_time then close m g i
    end

  let earlier m g i =
    if (not m.decided) && (m.by_time || Option.is_some m.question.within) then begin
      let { at; ahead } = judge m g i in
      look_at_state m g i at;
      if not m.decided then look_ahead m g i ahead
    end

  let path_for m g i =
    match m.question.within with
    | None when not m.by_time -> Graph.shortest_path g i
    | Some _ | None -> Graph.earliest_path g i

  let extent_of g i = function
    | None -> Timeline.Forever
    | Some k -> Timeline.Lasts (Graph.duration g (Graph.edges g i).(k))

  let trace_to m g (i, choice, moment) =
    let finish =
      match moment with
      | None -> At_state
      | Some moment ->
        let timeline = along m (Graph.tuple g i) (extent_of g i choice) in
        let sample = Timeline.sample timeline moment in
        let arrival = Graph.arrival g i in
        During { choice; moment; sample = sample_in_time m.question.within ~arrival moment sample }
    in
    { steps = path_for m g i; last = i; finish }

  (** {2 Doubts} *)

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

  let first_undefined m g = List.find_map (undefined_at m g) (List.sort_uniq Int.compare m.doubtful)

  let answer m g =
    match m.met with
    | Some place -> Met (trace_to m g place)
    | None -> (
        let unexplored =
          Seq.filter_map (fun (i, _) -> if arrives_in_time m g i then Some i else None) (Graph.unexpanded g)
        in
        match (unexplored (), first_undefined m g) with
        | Seq.Nil, None -> Never
        | (Seq.Nil | Cons _), undefined -> Open { unexplored; undefined })

  (** {2 All together} *)

  let monitor rests by_time question =
    { question; rests; by_time; met = None; decided = false; doubtful = [] }

  (* States that can be reached from some by edges without duration; and those edges, each with its choice: they
     are asked for several times, and a graph that keeps no edges makes them anew. *)
  let reached_at_once g arcs targets =
    let reached = Worklist.create (Graph.size g) and known = Edge_store.create () in
    for _ = 1 to Graph.size g do
      Edge_store.make_room known
    done;
    let visit i =
      let found = arcs i in
      let column f = Array.of_list (List.map f found) in
      Edge_store.set known i ~labels:(column snd) ~targets:(column fst);
      List.iter (fun (j, _) -> Worklist.add reached j) found
    in
    for n = 0 to Int_vector.length targets - 1 do
      Worklist.add reached (Int_vector.get targets n)
    done;
    Worklist.run reached visit;
    let arcs i = Array.to_list (Edge_store.get known i (fun choice target -> (target, choice))) in
    (Worklist.mem reached, arcs)

  (* The first cycle along which no time passes, of those that lead through what is inside. *)
  let find_cycle g arcs inside =
    let trace (i, cycle) =
      let stem = Graph.shortest_path g i in
      let steps = List.map (fun (source, choice) -> { Graph.source; choice }) cycle in
      { steps = List.append stem steps; last = i; finish = Repeats (List.length stem) }
    in
    Option.map trace (First_cycle.find ~size:(Graph.size g) ~inside arcs)

  let zeno_cycle g =
    let arcs i = List.map (fun (choice, target) -> (target, choice)) (Graph.edges_at_once g i) in
    match Graph.turning g with
    | Anywhere -> find_cycle g arcs (fun _ -> true)
    | At targets when Int_vector.length targets = 0 -> None
    | At targets ->
      let inside, arcs = reached_at_once g arcs targets in
      find_cycle g arcs inside

  (* Looking at a whole graph costs time in proportion to it: it is done each time that it has doubled. *)
  let at_doublings settled =
    let next = ref 16 and result = ref false in
    fun g ->
      if (not !result) && Graph.size g >= !next then begin
        next := 2 * Graph.size g;
        result := settled g
      end;
      !result

  let visitor observe monitors settled : Graph.visitor =
    let observe_all g i tuple = Option.iter (fun observe -> observe g i tuple) observe in
    let is_false = function Truth.False -> true | True | Undecided _ -> false in
    let rest_settled = ref (match settled with None -> true | Some _ -> false) in
    let look = Option.map at_doublings settled in
    let on_edges g i tuple edges =
      List.iter (fun m -> opened m g i tuple edges) monitors;
      Option.iter (fun look -> rest_settled := look g) look
    in
    let changes m = m.by_time || Option.is_some m.question.goal.along in
    let sees_edges = Option.is_some look || List.exists changes monitors in
    {
      found =
        (fun g i tuple ->
           observe_all g i tuple;
           List.iter (fun m -> found m g i tuple) monitors);
      opened = (if sees_edges then Some on_edges else None);
      earlier = (fun g i -> List.iter (fun m -> earlier m g i) monitors);
      (* What is decided asks for nothing more, and no other question for what comes after its time. *)
      matters =
        (fun time ->
           let asks m =
             (not m.decided)
             && match m.question.within with None -> true | Some bound -> Rat.compare time bound <= 0
           in
           match (monitors, look) with
           | [], None -> true
           | _ -> (not !rest_settled) || List.exists asks monitors);
      dull =
        (fun tuple ->
           Option.is_none observe
           && List.for_all (fun m -> m.decided || is_false (m.question.goal.at tuple)) monitors);
      enough =
        (fun () ->
           match (monitors, look) with
           | [], None -> false
           | _ -> !rest_settled && List.for_all (fun m -> m.decided) monitors);
    }

  let run ?observe ?(order = Graph.By_steps) ?keep_edges ?expanding ?settled ~rests limits
      around context questions =
    let by_time = match order with Graph.By_time -> true | By_steps -> false in
    let monitors = List.map (monitor rests by_time) questions in
    let visitor = visitor observe monitors settled in
    let graph = Graph.run ~visitor ~order ?keep_edges ?expanding limits around context in
    { graph; answers = List.map (fun m -> answer m graph) monitors; zeno = zeno_cycle graph }
end
