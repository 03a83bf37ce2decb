open Scc_base
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_engine

type policy = First | Random of int64 | Scheduled of Schedule.t
type limits = { steps : int option; time : Rat.t option; instant : int }

let default_instant = 10_000
let default_steps = 1_000

type given_up = { fault : Transition.fault; steps : int; time : Rat.t }
type ending = Open | Quiescent | Stuck of given_up | Zeno | Broken_off

let diagnostic model g =
  let where =
    if g.steps = 0 then "in the initial state"
    else Printf.sprintf "after step %d, at time %s" g.steps (Rat.to_string g.time)
  in
  { (Transition.diagnostic model g.fault) with notes = [ (Span.none, where) ] }

type event =
  | Start of State.t
  | Step of {
      number : int;
      index : int;
      among : int;
      free : bool;
      time : Rat.t;
      taken : Run.alternative;
      changes : unit -> Event_run.changes option;
      state : unit -> State.t;
      part : int list -> State.t;
      draws_on : bool;
    }
  | Instant of { offset : Rat.t; time : Rat.t; state : State.t }
  | End of {
      steps : int;
      time : Rat.t;
      ending : ending;
      last : (unit -> State.t) option;
      rounded : (Totals.t * Totals.t) option;
    }

type failure = Fault of given_up | Refused of Diag.t | Interrupted of Scc_graph_search.Limits.stop

(* What is left of the policy. *)
type guide = Always_first | Generator of Splitmix64.t | Choices of Schedule.choice list

type verdict = Take of int * guide | Wait of Rat.t * Schedule.choice * guide | Leave | Misfit of Schedule.choice

(* How far the run has come. *)
type place = {
  time : Rat.t;
  taken : int;  (** transitions so far *)
  counted : int;  (** of them, for [limits.steps] *)
  still : int;  (** of them, since time last passed, without draws, of which each instant has a few *)
  guide : guide;
}

(* What may happen next, or why nothing can and the run is over. *)
type ahead = Possible of Run.labels | Over of given_up

let nothing : Run.labels =
  let none _ = Bug.fail __POS__ "a transition that is not there" in
  { count = 0; label = none; chance = none; tie = None }

let transitions = function Possible labels -> labels | Over _ -> nothing

(* The first of those from a number on whose label passes the test, or how many there are. *)
let rec search (labels : Run.labels) test i =
  if i = labels.count || test (labels.label i) then i else search labels test (i + 1)

let ahead run place =
  let given_up fault = { fault; steps = place.taken; time = place.time } in
  match Run.labels run with
  | Ok labels -> Ok (Possible labels)
  | Error (Transition.Persistent_contact _ as fault) -> Ok (Over (given_up fault))
  | Error ((Bad_law _ | Bad_chance _) as fault) -> Error (Fault (given_up fault))

let possible (model : Model.t) transitions =
  let line i (label : Transition.label) =
    let less = match (model.splits, label) with Any_time, Time _ -> ", or any time before" | _ -> "" in
    Printf.sprintf "%d: %s%s" i (Transition.label_to_string model label) less
  in
  match Run.list transitions with
  | [] -> "nothing was possible there"
  | all -> "possible there: " ^ String.concat "; " (List.mapi line all)

let label_fits model label = function
  | None -> true
  | Some wanted -> String.equal wanted (Transition.label_to_string model label)

let index_of model (transitions : Run.labels) label =
  let i = search transitions (fun l -> label_fits model l (Some label)) 0 in
  if i < transitions.count then Some i else None

(* The number of the passing of time; where time may pass for ever, the one after all others. *)
let time_index transitions = search transitions Transition.is_time 0

(* Time that may be less than the greatest, where bonds may be released at any time (rule Time). *)
let part_of_time (model : Model.t) transitions (c : Schedule.choice) =
  match (model.splits, c.label) with
  | Every _, _ | _, None -> None
  | Any_time, Some label ->
    let at_place = match c.index with Some i -> i = time_index transitions | None -> true in
    if at_place then Transition.time_of_string label else None

(* A source of numbers from a generator, which is what is left of it afterwards. *)
let source g : Ties.source =
  let next (k, rest) =
    g := rest;
    k
  in
  {
    below = (fun n -> next (Splitmix64.below n !g));
    by_chance = (fun chances -> next (Splitmix64.by_chance (Array.of_list chances) !g));
  }

(* What chance decides by its chances; all choices alike, as nothing tells how likely they are. *)
let at_random (transitions : Run.labels) g =
  match transitions.tie with
  | Some { others; pick } ->
    let g = ref g in
    let source = source g in
    let i = if others = [] then 0 else source.below (1 + List.length others) in
    let i = if i = 0 then pick source else List.nth others (i - 1) in
    (i, !g)
  | None when Transition.is_drawn (transitions.label 0) ->
    Splitmix64.by_chance (Array.init transitions.count transitions.chance) g
  | None -> Splitmix64.below transitions.count g

(* Whether the choice of a transition was free: chance did not decide all. *)
let is_free_label (transitions : Run.labels) label =
  match transitions.tie with
  | Some { others; _ } -> others <> []
  | None -> transitions.count > 1 && not (Transition.is_drawn label)

let is_free transitions index = is_free_label transitions (transitions.Run.label index)

let decide model (transitions : Run.labels) guide =
  match guide with
  | Choices [] -> Leave
  | Choices (c :: rest) -> (
      let fits =
        match (c.Schedule.index, c.label) with
        | Some i, label ->
          if i >= 0 && i < transitions.count && label_fits model (transitions.label i) label then Some i else None
        | None, Some label -> index_of model transitions label
        | None, None -> None
      in
      match (fits, part_of_time model transitions c) with
      | Some i, _ -> Take (i, Choices rest)
      | None, Some d -> Wait (d, c, Choices rest)
      | None, None -> Misfit c)
  | (Always_first | Generator _) when transitions.count = 0 -> Leave
  | Always_first -> Take (0, guide)
  | Generator g ->
    let i, g = at_random transitions g in
    Take (i, Generator g)

let wanted (c : Schedule.choice) =
  match (c.index, c.label) with
  | Some i, Some l -> Printf.sprintf "choice %d, `%s`," i l
  | Some i, None -> Printf.sprintf "choice %d" i
  | None, Some l -> Printf.sprintf "`%s`" l
  | None, None -> "this"

let misfit model transitions place c =
  Refused
    (Diag.error Code.schedule_mismatch c.Schedule.at
       ~notes:[ (Span.none, possible model transitions) ]
       "step %d at time %s: %s is not possible here" (place.taken + 1) (Rat.to_string place.time) (wanted c))

let ending run limits place ahead =
  match ahead with
  | Over given_up -> Stuck given_up
  | Possible _ when place.still >= limits.instant -> Zeno
  | Possible { count; _ } when count > 0 -> Open
  | Possible _ ->
    if not (Run.quiescent run) then Bug.fail __POS__ "time cannot pass, and nothing collides (law Progress)";
    Quiescent

let duration = Transition.duration_of

(* How long time may pass here without an event: [None] when for ever. *)
let room run ahead =
  let weak : Transition.label -> bool = function Weak_split _ -> true | _ -> false in
  let labels = Run.list (transitions ahead) in
  match (ahead, labels) with
  | Possible _, [] when Run.quiescent run -> None
  | Possible _, _ :: _ when List.for_all weak labels -> None
  | (Possible _ | Over _), _ ->
    Some (List.fold_left (fun longest t -> Rat.max longest (duration t)) Rat.zero labels)

(* At the last transition, or so much later, if that instant has been told. *)
let finish ?offset run limits emit place ahead =
  let ending = ending run limits place ahead in
  let last = match offset with None -> Some (fun () -> Run.state run) | Some _ -> None in
  let time = Rat.add place.time (Option.value offset ~default:Rat.zero) in
  emit (End { steps = place.taken; time; ending; last; rounded = Run.rounded run });
  Ok ending

(* Leaves the run after [offset] more of undisturbed time, if that is possible. *)
let leave_at semantics run limits ~passing emit place ahead offset ~at =
  let fits = match room run ahead with None -> true | Some d -> Rat.compare offset d <= 0 in
  if not fits then
    Error
      (Refused
         (Diag.error Code.schedule_mismatch at
            ~notes:[ (Span.none, possible (Semantics.model semantics) (transitions ahead)) ]
            "after step %d at time %s: time cannot pass by %s here" place.taken (Rat.to_string place.time)
            (Rat.to_string offset)))
  else begin
    let state = Run.state run in
    if Rat.sign offset > 0 then passing ~start:place.time ~lasts:offset (fun () -> state);
    let state = if Rat.sign offset = 0 then state else Time.pass semantics offset state in
    emit (Instant { offset; time = Rat.add place.time offset; state });
    finish ~offset run limits emit place ahead
  end

let beyond (limits : limits) place d =
  match limits.time with
  | Some t when Rat.compare (Rat.add place.time d) t > 0 -> Some (Rat.sub t place.time)
  | _ -> None

let out_of_steps (limits : limits) place =
  match limits.steps with Some n -> place.counted >= n | None -> false

let advance place guide (taken : Run.alternative) ~counts =
  let d = duration taken.label in
  {
    time = Rat.add place.time d;
    taken = place.taken + 1;
    counted = (if counts then place.counted + 1 else place.counted);
    still =
      (if Rat.sign d > 0 then 0 else if Transition.is_drawn taken.label then place.still else place.still + 1);
    guide;
  }

(* The run is over: at the instant that the schedule names, or where time alone may go on to its limit. *)
let leave semantics run (limits : limits) ~passing emit place ahead (offset : (Rat.t * Span.t) option) =
  match (offset, limits.time, ahead) with
  | Some (d, at), _, _ -> leave_at semantics run limits ~passing emit place ahead d ~at
  | None, Some t, Possible { count = 0; _ }
    when Rat.compare t place.time > 0 && Run.quiescent run && not (Run.spinning run) ->
    leave_at semantics run limits ~passing emit place ahead (Rat.sub t place.time) ~at:Span.none
  | None, _, _ -> finish run limits emit place ahead

let not_asked ~start:_ ~lasts:_ _ = ()

let unbounded : Scc_graph_search.Limits.attempt = { run = (fun _ f -> Ok (f ())) }

let start_of : policy -> guide * (Rat.t * Span.t) option = function
  | First -> (Always_first, None)
  | Random seed -> (Generator (Splitmix64.of_seed seed), None)
  | Scheduled s -> (Choices s.choices, Option.map (fun d -> (d, s.offset_at)) s.offset)

(* After a step that was broken off no state is there. *)
let break_off run emit place ~within_step =
  let last = if within_step then None else Some (fun () -> Run.state run) in
  emit (End { steps = place.taken; time = place.time; ending = Broken_off; last; rounded = Run.rounded run })

let draws_on run (taken : Run.alternative) = Transition.is_drawn taken.label && Run.draws_on run

(* A step may take long, as its numbers do. *)
let attempted (attempt : Scc_graph_search.Limits.attempt) within_step f =
  within_step := true;
  let result = attempt.run Exploring f in
  within_step := Result.is_error result;
  Result.map_error (fun stop -> Interrupted stop) result

let run ?(passing = not_asked) ?(attempt = unbounded) ?(joint = false) semantics declared policy limits
    ~interrupted emit =
  let within_step = ref false in
  let step f = attempted attempt within_step f in
  let model = Semantics.model semantics and guide, offset = start_of policy in
  let* started = step (fun () -> Run.start semantics declared) in
  let* run = Result.map_error (fun fault -> Fault { fault; steps = 0; time = Rat.zero }) started in
  let state () = Run.state run and changes () = Run.changes run and part = Run.part run in
  let reached = ref { time = Rat.zero; taken = 0; counted = 0; still = 0; guide } in
  let rec from place =
    if interrupted () then Error (Interrupted Scc_graph_search.Limits.Interrupted)
    else
      let* ahead = Result.join (step (fun () -> ahead run place)) in
      if out_of_steps limits place || place.still >= limits.instant then finish run limits emit place ahead
      else
        let transitions = transitions ahead in
        match decide model transitions place.guide with
        | Leave -> leave semantics run limits ~passing emit place ahead offset
        | Misfit c -> Error (misfit model transitions place c)
        | Take (index, guide) ->
          let d = duration (transitions.label index) in
          within place ahead d (fun () ->
              passes place d;
              let* taken = step (fun () -> Run.take run index) in
              go_on place guide index transitions.count ~free:(is_free_label transitions taken.label) taken)
        | Wait (d, choice, guide) ->
          within place ahead d (fun () ->
              passes place d;
              let index = time_index transitions in
              let* waited = step (fun () -> Run.wait run d) in
              match waited with
              | Ok (Some taken) ->
                let free = is_free_label transitions taken.label in
                go_on place guide index (Int.max transitions.count (index + 1)) ~free taken
              | Ok None -> Error (misfit model transitions place choice)
              | Error fault -> Error (Fault { fault; steps = place.taken; time = place.time }))
  and passes place d = if Rat.sign d > 0 then passing ~start:place.time ~lasts:d state
  and within place ahead d go =
    match beyond limits place d with
    | Some d when Rat.sign d > 0 -> leave_at semantics run limits ~passing emit place ahead d ~at:Span.none
    | Some _ -> finish run limits emit place ahead
    | None -> go ()
  and go_on place guide index among ~free taken =
    let draws_on = draws_on run taken in
    let next = advance place guide taken ~counts:(not (joint && draws_on)) in
    let { taken = number; time; _ } = next in
    reached := next;
    emit (Step { number; index; among; free; time; taken; changes; state; part; draws_on });
    from next
  in
  emit (Start (state ()));
  let result = from !reached in
  (match result with
   | Error (Interrupted _) -> break_off run emit !reached ~within_step:!within_step
   | Ok _ | Error (Fault _ | Refused _) -> ());
  result
