open Scc_exact
open Scc_calculus
open Scc_semantics

type alternative = Event_run.alternative = {
  label : Transition.label;
  rules : Rule.t list;
  rounded : Totals.t Lazy.t option;
}

(* Bodies that draw at one instant, one after the other. Nothing that they are asked by changes before the last of
   them has drawn: so all of it is found when the first one draws, and the state is made when the last one has. *)
type draws = {
  drawn : Vec.t option array;  (** by first leaf, of those who have drawn *)
  mutable left : State.process list;  (** the others, in order *)
  mutable chances : (Vec.t * Rat.t) array option;  (** of the first of them, once they have been asked for *)
}

(* What may happen, of a network that does not run from event to event. *)
type ahead = Draws of draws | Events of (alternative * State.t) array

type stepwise = {
  semantics : Semantics.t;
  mutable present : State.t;  (** where somebody draws, before anybody has *)
  mutable ahead : (ahead, Transition.fault) result option;  (** once it has been asked for *)
  mutable rounded : Totals.sum;
  mutable elapsed : Scc_exact.Rat.t;
}

type t = Stepwise of stepwise | Eventwise of Event_run.t

let resume semantics s =
  if Event_run.can_run (Semantics.model semantics) then Eventwise (Event_run.start semantics s)
  else
    Stepwise
      { semantics; present = s; ahead = None; rounded = Totals.no_sum; elapsed = Scc_exact.Rat.zero }

let start semantics declared = Result.map (resume semantics) (Network.initial semantics declared)

let seen s (t : Transition.t) =
  let rounded = Totals.added (Semantics.model s.semantics) t in
  ({ label = t.label; rules = t.rules; rounded }, t.target)

let look s =
  match Steer.drawers s.semantics s.present with
  | _ :: _ as left ->
    let leaves = Array.length (Semantics.model s.semantics).leaves in
    Ok (Draws { drawn = Array.make leaves None; left; chances = None })
  | [] ->
    let* transitions = Network.successors s.semantics s.present in
    Ok (Events (Array.of_list (List.map (seen s) transitions)))

let ahead s =
  match s.ahead with
  | Some ahead -> ahead
  | None ->
    let ahead = look s in
    s.ahead <- Some ahead;
    ahead

let chances s d =
  match (d.chances, d.left) with
  | Some chances, _ -> Ok chances
  | None, p :: _ ->
    let* chances = Steer.chances s.semantics s.present p in
    let chances = Array.of_list chances in
    d.chances <- Some chances;
    Ok chances
  | None, [] -> Scc_base.Bug.fail __POS__ "nobody is left to draw"

type labels = { count : int; label : int -> Transition.label }

let list labels = List.init labels.count labels.label

let labels_ahead s =
  let* ahead = ahead s in
  match ahead with
  | Events events ->
    Ok { count = Array.length events; label = (fun i -> let (a : alternative), _ = events.(i) in a.label) }
  | Draws d ->
    let* chances = chances s d in
    let drawer = List.hd d.left in
    Ok { count = Array.length chances; label = (fun i -> Steer.draw_label drawer chances.(i)) }

let labels = function
  | Eventwise run -> Ok { count = Event_run.count run; label = Event_run.label run }
  | Stepwise s -> labels_ahead s

let go s ((taken : alternative), target) =
  Option.iter (fun added -> s.rounded <- Totals.accumulate s.rounded (Lazy.force added)) taken.rounded;
  s.elapsed <- Scc_exact.Rat.add s.elapsed (Transition.duration_of taken.label);
  s.present <- target;
  s.ahead <- None;
  taken

let velocity_of d (p : State.process) = d.drawn.(p.leaves.(0).leaf)
let no_such_alternative () = Scc_base.Bug.fail __POS__ "an alternative that is not there"

(* The last draw alone has consequences: the others' are that one has drawn. *)
let draw s d i =
  match (d.left, chances s d) with
  | p :: more, Ok chances when i >= 0 && i < Array.length chances -> (
      match more with
      | _ :: _ ->
        d.drawn.(p.leaves.(0).leaf) <- Some (fst chances.(i));
        d.left <- more;
        d.chances <- None;
        { label = Steer.draw_label p chances.(i); rules = Network.draw_rules; rounded = None }
      | [] -> (
          match Network.drawn s.semantics s.present ~before:(velocity_of d) p chances.(i) with
          | Ok transition -> go s (seen s transition)
          | Error _ -> Scc_base.Bug.fail __POS__ "laws that are asked while somebody draws"))
  | _, _ -> no_such_alternative ()

let take t i =
  match t with
  | Eventwise run ->
    let taken = Event_run.alternative run i in
    Event_run.take run i;
    taken
  | Stepwise s -> (
      match ahead s with
      | Ok (Draws d) -> draw s d i
      | Ok (Events events) when i >= 0 && i < Array.length events -> go s events.(i)
      | Ok (Events _) | Error _ -> no_such_alternative ())

let present s =
  match s.ahead with
  | Some (Ok (Draws d)) -> Steer.drawn (velocity_of d) s.present
  | Some (Ok (Events _) | Error _) | None -> s.present

let wait t d =
  match t with
  | Eventwise run -> Ok (Event_run.wait run d)
  | Stepwise s ->
    Result.map (Option.map (fun transition -> go s (seen s transition))) (Network.wait s.semantics (present s) d)

let changes = function Eventwise run -> Some (Event_run.changes run) | Stepwise _ -> None
let elapsed = function Eventwise run -> Event_run.elapsed run | Stepwise s -> s.elapsed
let state = function Eventwise run -> Event_run.state run | Stepwise s -> present s

(* Without laws of motion, whatever may ever happen gives time a place to pass to: see {!Time.delay}. *)
let quiescent = function
  | Eventwise run -> Event_run.count run = 0
  | Stepwise s -> Network.quiescent s.semantics (present s)

let spinning t = Array.exists Turn.spinning (state t).processes

let rounded = function
  | Eventwise _ -> None
  | Stepwise s ->
    if Model.rounds (Semantics.model s.semantics) then Some (Totals.bounds s.rounded) else None
