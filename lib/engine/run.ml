open Scc_calculus
open Scc_semantics

type alternative = Event_run.alternative = {
  label : Transition.label;
  rules : Rule.t list;
  rounded : Totals.t Lazy.t option;
}

(* Where it cannot run from event to event: the present state and, once they have been asked for, its
   transitions. *)
type stepwise = {
  semantics : Semantics.t;
  mutable present : State.t;
  mutable next : ((alternative * State.t) list, Transition.fault) result option;  (** with where they lead *)
  mutable rounded : Totals.sum;
  mutable elapsed : Scc_exact.Rat.t;
}

type t = Stepwise of stepwise | Eventwise of Event_run.t

let resume semantics s =
  if Event_run.can_run (Semantics.model semantics) then Eventwise (Event_run.start semantics s)
  else
    Stepwise
      { semantics; present = s; next = None; rounded = Totals.no_sum; elapsed = Scc_exact.Rat.zero }

let start semantics declared = Result.map (resume semantics) (Network.initial semantics declared)

let seen s (t : Transition.t) =
  let rounded = Totals.added (Semantics.model s.semantics) t in
  ({ label = t.label; rules = t.rules; rounded }, t.target)

let next s =
  match s.next with
  | Some next -> next
  | None ->
    let next = Result.map (List.map (seen s)) (Network.successors s.semantics s.present) in
    s.next <- Some next;
    next

let alternatives = function
  | Eventwise run -> Ok (Event_run.alternatives run)
  | Stepwise s -> Result.map (List.map fst) (next s)

let go s ((taken : alternative), target) =
  Option.iter (fun added -> s.rounded <- Totals.accumulate s.rounded (Lazy.force added)) taken.rounded;
  s.elapsed <- Scc_exact.Rat.add s.elapsed (Transition.duration_of taken.label);
  s.present <- target;
  s.next <- None

let take t i =
  match t with
  | Eventwise run -> Event_run.take run i
  | Stepwise s -> (
      match next s with
      | Ok transitions when i >= 0 && i < List.length transitions -> go s (List.nth transitions i)
      | Ok _ | Error _ -> Scc_base.Bug.fail __POS__ "an alternative that is not there")

let wait t d =
  match t with
  | Eventwise run -> Ok (Event_run.wait run d)
  | Stepwise s ->
    let went transition =
      let taken = seen s transition in
      go s taken;
      fst taken
    in
    Result.map (Option.map went) (Network.wait s.semantics s.present d)

let changes = function Eventwise run -> Some (Event_run.changes run) | Stepwise _ -> None
let elapsed = function Eventwise run -> Event_run.elapsed run | Stepwise s -> s.elapsed
let state = function Eventwise run -> Event_run.state run | Stepwise s -> s.present

(* Without laws of motion, whatever may ever happen gives time a place to pass to: see {!Time.delay}. *)
let quiescent = function
  | Eventwise run -> Event_run.alternatives run = []
  | Stepwise s -> Network.quiescent s.semantics s.present

let spinning t = Array.exists Turn.spinning (state t).processes

let rounded = function
  | Eventwise _ -> None
  | Stepwise s ->
    if Model.rounds (Semantics.model s.semantics) then Some (Totals.bounds s.rounded) else None
