open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_graph_search

type limits = { states : int; stop : unit -> Limits.stop option }

let default_states = 20_000

type hypothesis = {
  state : State.t;
  time : Rat.t;
  next : int;
  ahead : Burst.event list;
  choices : (int * string) list;
  last : (Transition.label * Rule.t list * Rat.t) option;
  deviation : Against.deviation;
  transitions : (Transition.t list, Transition.fault) result Lazy.t;
  untold : untold option;
}

and untold = { before : hypothesis; labels : Transition.label list }

type possible = { from : hypothesis; taken : Transition.t }
type misfit = { of_ : hypothesis; differences : Against.difference list }

type dead_end = {
  reached : hypothesis list;
  possible : possible list;
  misfits : misfit list;
}

(* In a dead end there are none (rule DeadEnd). *)
let successors against state =
  match Network.successors (Against.semantics against) state with
  | Error (Transition.Persistent_contact _) -> Ok []
  | result -> result

type reason = Too_many_states | Fault of Transition.fault | Stopped of Limits.stop

type outcome =
  | Met of { run : hypothesis; widest : int }
  | Dead_end of dead_end
  | Unknown of { reason : reason; items : int }

(* {1 Sets of hypotheses} *)

module Place = struct
  type t = hypothesis

  let same_untold a b =
    List.equal Transition.equal_label a.labels b.labels && State.equal a.before.state b.before.state

  let equal a b =
    a.next = b.next && Rat.equal a.time b.time
    && List.equal Burst.equal a.ahead b.ahead
    && State.equal a.state b.state
    && Option.equal same_untold a.untold b.untold

  let hash h = (((State.hash h.state * 31) + Rat.hash h.time) * 31) + h.next
end

module Places = Hashtbl.Make (Place)

(* {1 One search} *)

type t = {
  against : Against.t;
  items : Recorded.item array;
  latest : Rat.t array;  (* the latest time up to each item, from 0 *)
  observed : Transition.label -> bool;
  limits : limits;
}

(* What is found from the hypotheses that have met the same number of items. *)
type layer = {
  queue : hypothesis Queue.t;
  known : unit Places.t;
  onward : hypothesis Queue.t;  (* that have met one more *)
  onward_known : unit Places.t;
  mutable found : dead_end;
  mutable fault : Transition.fault option;
}

let push queue known h =
  if not (Places.mem known h) then begin
    Places.add known h ();
    Queue.add h queue
  end

let add = Rat.add
let least_time t h = add h.time (Rat.neg (Against.tolerance t.against))
let in_time t h (item : Recorded.item) =
  Rat.compare (Rat.abs (Rat.sub h.time item.time)) (Against.tolerance t.against) <= 0

(* The next item that is not met, past those that were met ahead of it. *)
let rec settled h =
  match h.ahead with
  | e :: rest when e.Burst.item = h.next -> settled { h with next = h.next + 1; ahead = rest }
  | _ -> h

let met_next h = settled { h with next = h.next + 1 }

(* In [target], by an event of [h]. *)
let met h ~firsts target item =
  if item = h.next then met_next target
  else
    let e = Burst.met h.state ~firsts ~time:h.time ~item ~order:(List.length h.choices) in
    let earlier, later = List.partition (fun (o : Burst.event) -> o.item < item) h.ahead in
    { target with ahead = earlier @ (e :: later) }

(* {2 Events} *)

(* The items that an event of the model can be: of those that are not met, the first that names a process of it, if
   it fits and its time does. Looking on past others takes that they are of other processes, and a tolerance: exact
   traces tell their order. What was recorded of a state waits for all events before it. *)
let fitting t h label =
  let latest = add h.time (Against.tolerance t.against) in
  let exact = Rat.sign (Against.tolerance t.against) = 0 in
  let rec from i passed found =
    if i >= Array.length t.items || Rat.compare t.items.(i).time latest > 0 || (exact && i > h.next) then found
    else if List.exists (fun (e : Burst.event) -> e.item = i) h.ahead then from (i + 1) passed found
    else
      match t.items.(i).what with
      | Event e ->
        let processes = Against.processes_of t.against h.state e in
        let free = not (List.exists (fun p -> List.mem p passed) processes) in
        let fits = free && in_time t h t.items.(i) && Against.matches t.against h.state e label in
        from (i + 1) (processes @ passed)
          (if fits then (i, processes) :: found else found)
      | State _ | Watched | Quiescent | Stuck -> if i = h.next then [] else from (i + 1) passed found
  in
  from h.next [] []

let after t h index (taken : Transition.t) =
  let time = add h.time (Transition.duration taken) in
  {
    h with
    state = taken.target; time;
    transitions = lazy (successors t.against taken.target);
    choices = (index, Transition.label_to_string (Against.model t.against) taken.label) :: h.choices;
    last = Some (taken.label, taken.rules, time);
  }

let off_time h (item : Recorded.item) =
  { Against.no_deviation with time = Rat.abs (Rat.sub h.time item.time) }

(* By each item that an event of [h] with this label can be. *)
let meet t layer h label target =
  List.iter
    (fun (item, firsts) ->
       let deviation = Against.later h.deviation (off_time h t.items.(item)) in
       push layer.onward layer.onward_known (met h ~firsts { target with deviation } item))
    (fitting t h label)

(* Bonds that are released at once (rule Lot) may be told one by one, in any order. *)
let one_by_one : Transition.label -> Transition.label list = function
  | Weak_split (_ :: _ :: _ as releases) -> List.map (fun r -> Transition.Weak_split [ r ]) releases
  | Weak_split _ | Time _ | Bind _ | Close _ | Bounce _ | Absorb _ | Strong_split _ | Draw _ | Lot _ -> []

let is_observed t label =
  match one_by_one label with [] -> t.observed label | labels -> List.exists t.observed labels

let rec each_of_them passed f = function
  | [] -> ()
  | label :: later ->
    f label (List.rev_append passed later);
    each_of_them (label :: passed) f later

let tell_one t layer ~before labels target =
  let one label rest =
    let untold = if List.exists t.observed rest then Some { before; labels = rest } else None in
    meet t layer before label { target with untold }
  in
  each_of_them [] one labels

let event t layer h index (taken : Transition.t) =
  layer.found <- { layer.found with possible = { from = h; taken } :: layer.found.possible };
  let target = after t h index taken in
  meet t layer h taken.label target;
  tell_one t layer ~before:h (one_by_one taken.label) target;
  if not (is_observed t taken.label) then push layer.queue layer.known target

(* {2 Time} *)

(* Time may pass up to where the next item would be too long ago. *)
let passing t layer h index (taken : Transition.t) =
  let target = after t h index taken in
  if Rat.compare (least_time t target) t.items.(h.next).time <= 0 then push layer.queue layer.known target

(* Where bonds may be released at any time, less time may pass than until the next transition: just as much as
   until the next item, which may be that release. All times of such traces are exact. *)
let stop t h transitions =
  let at_any_time = Process.splits_at_any_time (Against.model t.against) in
  if not (Array.exists at_any_time h.state.State.processes) then None
  else
    let numbered = List.mapi (fun i x -> (i, x)) transitions in
    let is_time (_, (x : Transition.t)) = Transition.is_time x.label in
    let index = match List.find_opt is_time numbered with Some (i, _) -> i | None -> List.length transitions in
    match Network.wait (Against.semantics t.against) h.state (Rat.sub t.items.(h.next).time h.time) with
    | Ok (Some taken) -> Some (index, taken)
    | Ok None | Error _ -> None

(* {2 States and claims} *)

(* The state at a time between this one and the next transition. *)
let meanwhile t h transitions time =
  let offset = Rat.sub time h.time in
  let before (x : Transition.t) = Rat.compare offset (Transition.duration x) < 0 in
  let may_pass =
    match transitions with
    | [] -> Network.quiescent (Against.semantics t.against) h.state
    | _ :: _ -> List.exists before transitions
  in
  if Rat.sign offset > 0 && may_pass then Some (Time.pass (Against.semantics t.against) offset h.state) else None

let state t layer h transitions (item : Recorded.item) bodies step =
  let compare now = Burst.differences t.against ~now ~time:item.time h.ahead bodies step in
  let now = if in_time t h item then Some (compare h.state) else None in
  let then_ =
    match now with
    | Some ([], _) -> None
    | _ -> Option.map compare (meanwhile t h transitions item.time)
  in
  let accept deviation = Some (Against.later h.deviation deviation) in
  match (now, then_) with
  | Some ([], d), _ -> accept (Against.later d (off_time h item))
  | _, Some ([], d) -> accept d
  | _, Some (differences, _) | Some (differences, _), None ->
    layer.found <- { layer.found with misfits = { of_ = h; differences } :: layer.found.misfits };
    None
  | None, None -> None

let urgent (x : Transition.t) = Transition.is_urgent x.label

(* All that has to happen before the time of the item, or at it if the times are exact, has happened. *)
let watched t h transitions (item : Recorded.item) =
  let urgently = List.exists urgent transitions in
  let in_past = Rat.compare (add h.time (Against.tolerance t.against)) item.time <= 0 in
  let reaches =
    in_time t h item || Option.is_some (meanwhile t h transitions item.time)
  in
  reaches && not (urgently && in_past)

(* Items that are no events move no state on, so that their times have to be held against those before. *)
let goes_back t i = Rat.compare (add t.items.(i).time (Against.tolerance t.against)) t.latest.(i) < 0

let claim t layer h transitions =
  let item = t.items.(h.next) in
  let deviation =
    match item.what with
    | Event _ -> None
    | State _ | Watched | Quiescent | Stuck when goes_back t h.next -> None
    | State (bodies, step) -> state t layer h transitions item bodies step
    | Watched -> if watched t h transitions item then Some h.deviation else None
    | Quiescent ->
      let quiescent () = Network.quiescent (Against.semantics t.against) h.state in
      if transitions = [] && quiescent () then Some h.deviation else None
    | Stuck ->
      let stuck = transitions = [] && not (Network.quiescent (Against.semantics t.against) h.state) in
      if stuck && in_time t h item then Some h.deviation
      else None
  in
  Option.iter
    (fun deviation -> push layer.onward layer.onward_known (met_next { h with deviation }))
    deviation

(* {2 Layers} *)

let expand t layer h =
  layer.found <- { layer.found with reached = h :: layer.found.reached };
  match (h.untold, Lazy.force h.transitions) with
  | Some { before; labels }, _ ->
    let before = { before with next = h.next; ahead = h.ahead; deviation = h.deviation } in
    tell_one t layer ~before labels h
  | None, Error fault -> layer.fault <- Some fault
  | None, Ok transitions ->
    claim t layer h transitions;
    List.iteri
      (fun index (taken : Transition.t) ->
         if Transition.is_time taken.label then passing t layer h index taken
         else event t layer h index taken)
      transitions;
    Option.iter (fun (index, taken) -> passing t layer h index taken) (stop t h transitions)

type step = Onward of hypothesis Queue.t * reason option | Over of outcome

(* What was not looked at, in this layer or an earlier one, is [missed]: without it nothing diverges. *)
let layer t queue ~items ~missed =
  let layer =
    {
      queue; known = Places.create 16; onward = Queue.create (); onward_known = Places.create 16;
      found = { reached = []; possible = []; misfits = [] };
      fault = None;
    }
  in
  Queue.iter (fun h -> Places.replace layer.known h ()) queue;
  let rec from count =
    match t.limits.stop () with
    | Some stop -> Over (Unknown { reason = Stopped stop; items })
    | None -> (
        match if count >= t.limits.states then None else Queue.take_opt layer.queue with
        | Some h ->
          expand t layer h;
          from (count + 1)
        | None -> (
            let cut = if Queue.is_empty layer.queue then missed else Some Too_many_states in
            let missed =
              match (cut, layer.fault) with
              | Some reason, _ -> Some reason
              | None, Some fault -> Some (Fault fault)
              | None, None -> None
            in
            match missed with
            | _ when not (Queue.is_empty layer.onward) -> Onward (layer.onward, missed)
            | Some reason -> Over (Unknown { reason; items })
            | None -> Over (Dead_end layer.found)))
  in
  from 0

let run against (trace : Recorded.t) declared ~observed limits =
  let latest = Array.make (Array.length trace.items) Rat.zero in
  let before i = if i = 0 then Rat.zero else latest.(i - 1) in
  Array.iteri (fun i (item : Recorded.item) -> latest.(i) <- Rat.max (before i) item.time) trace.items;
  let t = { against; items = trace.items; latest; observed; limits } in
  let start state =
    {
      state; time = Rat.zero; next = 0; ahead = []; choices = []; last = None; deviation = Against.no_deviation;
      untold = None; transitions = lazy (successors against state);
    }
  in
  let rec layers queue items ~missed widest =
    let widest = max widest (Queue.length queue) in
    if items = Array.length t.items then Met { run = Queue.peek queue; widest }
    else
      match layer t queue ~items ~missed with
      | Onward (queue, missed) -> layers queue (items + 1) ~missed widest
      | Over outcome -> outcome
  in
  Result.map
    (fun state ->
       let queue = Queue.create () in
       Queue.add (start state) queue;
       layers queue 0 ~missed:None 1)
    (Network.initial (Against.semantics against) declared)

(* {1 Looking on} *)

(* No trace tells lots, and so they are passed over like time. What is kept comes last of the lots of a bond:
   only where all are kept time goes on, so that places are found in the order of time. *)
let silent (x : Transition.t) =
  match x.label with
  | Time _ | Lot _ -> true
  | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ -> false

let beyond against state time ~steps =
  let rec go (left, found) state time =
    if left = 0 then (left, found)
    else
      let here = (left - 1, (state, time) :: found) in
      match successors against state with
      | Error _ -> here
      | Ok transitions ->
        let follow so_far (x : Transition.t) = go so_far x.target (add time (Transition.duration x)) in
        List.fold_left follow here (List.filter silent transitions)
  in
  List.rev (snd (go (steps, []) state time))
