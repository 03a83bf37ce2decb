open Scc_ctl
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_evaluate

type visit = { state : State.t; arrived : int list; halted : bool }
type t = { visits : visit list; passings : (State.t * Rat.t option) list; complete : bool }

module Seen = Hashtbl.Make (struct
    type t = visit

    let equal a b =
      State.equal a.state b.state && List.equal Int.equal a.arrived b.arrived && Bool.equal a.halted b.halted

    let hash v = State.hash v.state
  end)

let ok c = function
  | Ok x -> x
  | Error fault -> failwith (Transition.diagnostic (Semantics.model c) fault).message

let is_late horizon (s : State.t) =
  match (horizon, s.time) with Some h, Some t -> Rat.compare t h > 0 | None, _ | _, None -> false

(* The next of the instants strictly before what time would pass to. *)
let stop c instants (s : State.t) =
  match s.time with
  | None -> None
  | Some now ->
    let left t = Rat.sub t now in
    let before t =
      Rat.sign (left t) > 0
      && match Time.delay c s with None -> true | Some d -> Rat.compare (left t) d < 0
    in
    Option.map left (List.find_opt before instants)

let explore c ~events ~horizon ~instants ~limit start =
  let instants = List.sort_uniq Rat.compare instants in
  let seen = Seen.create 64 and queue = Queue.create () in
  let visits = ref [] and passings = ref [] and complete = ref true in
  let add v =
    if not (is_late horizon v.state || Seen.mem seen v) then
      if Seen.length seen >= limit then complete := false
      else begin
        Seen.add seen v ();
        visits := v :: !visits;
        Queue.add v queue
      end
  in
  let arrived source label =
    List.filter (fun i -> Event.matches ~source label events.(i)) (List.init (Array.length events) Fun.id)
  in
  let follow v =
    let transitions = ok c (Network.successors c v.state) in
    let next (t : Transition.t) =
      let arrived = if Transition.is_time t.label then [] else arrived v.state t.label in
      add { state = t.target; arrived; halted = false }
    in
    List.iter next transitions;
    let urgent = List.exists (fun (t : Transition.t) -> Transition.is_urgent t.label) transitions in
    let may_split = Array.exists (fun (p : State.process) -> Option.is_some p.clock) v.state.processes in
    if not urgent then begin
      passings := (v.state, Time.delay c v.state) :: !passings;
      match if may_split then stop c instants v.state else None with
      | None -> ()
      | Some d ->
        Option.iter
          (fun (t : Transition.t) -> add { state = t.target; arrived = []; halted = true })
          (ok c (Network.wait c v.state d))
    end
  in
  add { state = start; arrived = []; halted = false };
  let rec go () =
    match Queue.take_opt queue with
    | None -> ()
    | Some v ->
      follow v;
      go ()
  in
  go ();
  { visits = !visits; passings = !passings; complete = !complete }

let times p = List.sort_uniq Rat.compare (List.filter_map (fun v -> v.state.time) p.visits)

let holds c ~events prop v =
  let is event i = Formula.equal_event events.(i) event in
  let arrived event = List.exists (is event) v.arrived in
  (Trajectory.predicate c prop (Trajectory.make ~arrived c v.state Instant)).start

let while_passing c prop (s, d) =
  let extent = match d with None -> Timeline.Forever | Some d -> Timeline.Lasts d in
  let line = Trajectory.predicate c prop (Trajectory.make c s extent) in
  line.first :: List.concat_map (fun (p : Truth.t Timeline.piece) -> [ p.at; p.after ]) line.rest
