open Scc_exact
open Scc_calculus
open Scc_semantics

type alternative = Event_run.alternative = {
  label : Transition.label;
  rules : Rule.t list;
  rounded : Totals.t Lazy.t option;
  replaced : (State.process list * State.process list) option;
}

(* What may happen, of a network that does not run from event to event. *)
type ahead = Draws of Draws.t | Events of (alternative * Transition.t) array

type stepwise = {
  semantics : Semantics.t;
  mutable present : State.t;  (** where somebody draws, before anybody has *)
  mutable ahead : (ahead, Transition.fault) result option;  (** once it has been asked for *)
  mutable rounded : Totals.sum;
  mutable elapsed : Scc_exact.Rat.t;
}

type way = Stepwise of stepwise | Eventwise of Event_run.t
type t = { mutable way : way }

let stepwise ?(elapsed = Rat.zero) semantics present =
  Stepwise { semantics; present; ahead = None; rounded = Totals.no_sum; elapsed }

let resume semantics s =
  if Event_run.can_run (Semantics.model semantics) then { way = Eventwise (Event_run.start semantics s) }
  else { way = stepwise semantics s }

(* Where laws may have no value, the rules alone say what is reported, and when. *)
let way t =
  match t.way with
  | Eventwise run when Event_run.may_fail run ->
    t.way <- stepwise ~elapsed:(Event_run.elapsed run) (Event_run.semantics run) (Event_run.state run);
    t.way
  | (Eventwise _ | Stepwise _) as way -> way

let start semantics declared = Result.map (resume semantics) (Network.initial semantics declared)

let eventwise = Event_run.can_run
let inertial m = Model.straight m && eventwise m

let seen s (t : Transition.t) =
  let rounded = Totals.added (Semantics.model s.semantics) t in
  ({ label = t.label; rules = t.rules; rounded; replaced = None }, t)

let look s =
  match Draws.waiting s.semantics s.present with
  | Some draws -> Ok (Draws draws)
  | None ->
    let* transitions = Network.successors s.semantics s.present in
    Ok (Events (Array.of_list (List.map (seen s) transitions)))

let ahead s =
  match s.ahead with
  | Some ahead -> ahead
  | None ->
    let ahead = look s in
    s.ahead <- Some ahead;
    ahead

type labels = {
  count : int;
  label : int -> Transition.label;
  chance : int -> Rat.t;
  tie : Ties.tie option;
}

let list labels = List.init labels.count labels.label

(* Where chance decides between urgent transitions. *)
let tie transitions =
  let with_chance i (t : Transition.t) = Option.map (fun chance -> (i, chance)) t.chance in
  match List.filter_map Fun.id (List.mapi with_chance transitions) with
  | (i, _) :: _ as urgent when not (Transition.is_drawn (List.nth transitions i).label) ->
    let others i = if List.mem_assoc i urgent then None else Some i in
    let pick (source : Ties.source) = fst (List.nth urgent (source.by_chance (List.map snd urgent))) in
    Some { Ties.others = List.filter_map others (List.init (List.length transitions) Fun.id); pick }
  | _ -> None

let labels_ahead s =
  let* ahead = ahead s in
  match ahead with
  | Events events ->
    let label i = let (a : alternative), _ = events.(i) in a.label in
    let chance i = Transition.chance (label i) in
    Ok { count = Array.length events; label; chance; tie = tie (Array.to_list (Array.map snd events)) }
  | Draws d ->
    let* chances = Draws.chances s.semantics d in
    let drawer = Draws.drawer d in
    let label i = Steer.draw_label drawer chances.(i) and chance i = snd chances.(i) in
    Ok { count = Array.length chances; label; chance; tie = None }

let labels t =
  match way t with
  | Eventwise run ->
    let label = Event_run.label run and chance = Event_run.chance run in
    Ok { count = Event_run.count run; label; chance; tie = Event_run.tie run }
  | Stepwise s -> labels_ahead s

let go s ((taken : alternative), (transition : Transition.t)) =
  Option.iter (fun added -> s.rounded <- Totals.accumulate s.rounded (Lazy.force added)) taken.rounded;
  s.elapsed <- Scc_exact.Rat.add s.elapsed (Transition.duration_of taken.label);
  s.present <- transition.target;
  s.ahead <- None;
  taken

let no_such_alternative () = Scc_base.Bug.fail __POS__ "an alternative that is not there"

(* The last draw alone has consequences: the others' are that one has drawn. *)
let draw s d i =
  match Draws.chances s.semantics d with
  | Ok chances when i >= 0 && i < Array.length chances -> (
      let p = Draws.drawer d in
      if not (Draws.draw d (fst chances.(i))) then
        { label = Steer.draw_label p chances.(i); rules = Network.draw_rules; rounded = None; replaced = None }
      else
        match Network.drawn s.semantics s.present ~before:(Draws.before d) p chances.(i) with
        | Ok transition -> go s (seen s transition)
        | Error _ -> Scc_base.Bug.fail __POS__ "laws that are asked while somebody draws")
  | Ok _ | Error _ -> no_such_alternative ()

let take t i =
  match way t with
  | Eventwise run -> Event_run.take run i
  | Stepwise s -> (
      match ahead s with
      | Ok (Draws d) -> draw s d i
      | Ok (Events events) when i >= 0 && i < Array.length events -> go s events.(i)
      | Ok (Events _) | Error _ -> no_such_alternative ())

let present s =
  match s.ahead with
  | Some (Ok (Draws d)) -> Draws.state d
  | Some (Ok (Events _) | Error _) | None -> s.present

let wait t d =
  match way t with
  | Eventwise run -> Ok (Event_run.wait run d)
  | Stepwise s ->
    Result.map (Option.map (fun transition -> go s (seen s transition))) (Network.wait s.semantics (present s) d)

let changes t = match t.way with Eventwise run -> Some (Event_run.changes run) | Stepwise _ -> None
let elapsed t = match t.way with Eventwise run -> Event_run.elapsed run | Stepwise s -> s.elapsed
let state t = match t.way with Eventwise run -> Event_run.state run | Stepwise s -> present s

let draws_on t =
  match t.way with
  | Eventwise run -> Event_run.draws_on run
  | Stepwise { ahead = Some (Ok (Draws _)); _ } -> true
  | Stepwise s -> (
      match Lots.due (Semantics.model s.semantics) s.present with
      | Some (To_draw _ | To_be_first _) -> true
      | Some (To_choose _ | To_release _) -> false
      | None -> Option.is_some (Steer.next_to_draw s.semantics s.present))

let part t leaves =
  match t.way with
  | Eventwise run -> Event_run.part run leaves
  | Stepwise s -> State.with_leaves (present s) leaves

(* From event to event, whatever may ever happen gives time a place to pass to: see {!Time.delay}. *)
let quiescent t =
  match way t with
  | Eventwise run -> Event_run.count run = 0
  | Stepwise s -> Network.quiescent s.semantics (present s)

let spinning t = Array.exists Turn.spinning (state t).processes

let rounded t =
  match t.way with
  | Eventwise _ -> None
  | Stepwise s ->
    if Model.rounds (Semantics.model s.semantics) then Some (Totals.bounds s.rounded) else None
