open Scc_data
open Scc_exact

module Make (L : Lts.S) = struct
  type edge = { label : int; target : int }
  type step = { source : int; choice : int }
  type order = By_steps | By_time

  type turning = At of Int_vector.t | Anywhere

  type t = {
    context : L.context;
    order : order;
    tuples : Tuples.t;
    near : Tuples.spread;  (** the state being expanded *)
    reader : Tuples.spread;  (** the state that was read last *)
    distances : Distances.t;
    statuses : L.fault Statuses.t;
    frontier : Frontier.t;
    edges : Edge_store.t option;
    at_once : Edges_at_once.t;
    mutable targets : int array;  (** of the state being expanded, and room for more *)
    mutable labels : int array;  (** the same, where other processes have found its edges *)
    mutable transitions : int;
    mutable turning : turning;
    timed : Timed_labels.t;
    mutable shared : Shared_states.t option;  (** what other processes see of them *)
  }

  let make_room_for_targets g count =
    if count > Array.length g.targets then begin
      g.targets <- Array.make (2 * count) (-1);
      g.labels <- Array.make (2 * count) (-1)
    end

  let may_turn g = match g.turning with At states -> Int_vector.length states > 0 | Anywhere -> true
  let context g = g.context
  let size g = Tuples.size g.tuples
  let depth g i = Distances.depth g.distances i
  let arrival g i = Distances.arrival g.distances i
  let transitions g = g.transitions
  let turning g = g.turning
  let duration g e = L.duration g.context e.label

  let tuple g i =
    Tuples.load g.tuples g.reader i;
    Tuples.slots g.reader

  let read_tuple g i room =
    Tuples.load g.tuples g.reader i;
    Tuples.read_slots g.reader room

  (** {2 Statuses} *)

  let status g i = Statuses.get g.statuses i
  let is_expanded g i = Statuses.is_expanded g.statuses i

  let unexpanded g =
    let rec from i () =
      if i >= size g then Seq.Nil
      else
        match status g i with
        | Unexpanded reason -> Seq.Cons ((i, reason), from (i + 1))
        | Expanded | Queued -> from (i + 1) ()
    in
    from 0

  let left g = Statuses.unexpanded g.statuses
  let left_for g reason = Statuses.count g.statuses reason

  let complete g =
    let rec from i = i = size g || (is_expanded g i && from (i + 1)) in
    from 0

  let greatest_depth g = Distances.greatest_depth g.distances
  let greatest_arrival g = Distances.greatest_arrival g.distances

  (** {2 Edges} *)

  let takes_time g label = Timed_labels.takes_time g.timed label
  let transitions_of g label = Timed_labels.transitions g.timed label

  let edge_of_step g (s : Lts.step) =
    match Tuples.find g.tuples ~near:g.reader s.changes with
    | -1 -> Scc_base.Bug.fail __POS__ "a transition that is made again leads to no state of the graph"
    | target -> { label = s.label; target }

  let made_anew g i =
    let tuple = tuple g i in
    let steps =
      if Statuses.is_reduced g.statuses i then L.reduced g.context tuple
      else Result.to_option (L.successors g.context tuple)
    in
    match steps with
    | Some steps -> Array.of_list (List.map (edge_of_step g) steps)
    | None -> Scc_base.Bug.fail __POS__ "the transitions of a state cannot be made again"

  (* Whether a transition of the state that is loaded, to be expanded, leads to another one that will be later.
  *)
  let is_ahead g (s : Lts.step) =
    let target changes = Tuples.find g.tuples ~near:g.near changes in
    match target s.changes with
    | -1 -> true
    | j -> j <> target [||] && (match status g j with Queued -> true | Expanded | Unexpanded _ -> false)

  (* Of a state whose transitions have been made, though it may not have been looked at to the end. *)
  let known_edges g i =
    match g.edges with
    | None -> made_anew g i
    | Some store -> Edge_store.get store i (fun label target -> { label; target })

  let edges g i = if is_expanded g i then known_edges g i else [||]

  (* Of most states it has been noted that there are none. *)
  let edges_at_once g i =
    if Statuses.is_timed g.statuses i || not (is_expanded g i) then []
    else
      match Edges_at_once.find g.at_once i with
      | Some known -> known
      | None ->
        Array.to_list (Array.mapi (fun choice e -> (choice, e)) (edges g i))
        |> List.filter_map (fun (choice, e) -> if takes_time g e.label then None else Some (choice, e.target))

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
    | _ when (not timed) && Statuses.is_timed g.statuses i -> [||]
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

  let before g i =
    match Distances.before_nearest g.distances i with
    | -1 -> None
    | j -> Some j

  let shortest_path g i = path g Distances.before_nearest (fun _ _ _ -> true) i

  let earliest_path g i =
    let in_time source target e = Rat.equal (arrival g target) (Rat.add (arrival g source) (duration g e)) in
    path g Distances.before_earliest in_time i

  type memory = { states : int; labels : int; edges : int }

  let memory g =
    {
      states = Tuples.bytes g.tuples;
      labels = Distances.bytes g.distances + Statuses.bytes g.statuses;
      edges = Option.fold ~none:(Edges_at_once.bytes g.at_once) ~some:Edge_store.bytes g.edges;
    }

end
