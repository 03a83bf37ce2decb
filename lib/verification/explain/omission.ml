open Scc_ctl
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_motion
open Scc_property
open Scc_evaluate
module Ints = Set.Make (Int)

type role = Irrelevant | Cause | Keeps_away
type body = int list

type t = {
  story : Causes.t;
  basis : Causes.basis;
  roles : role array;
  facts : string list;
  left_out : body list;
  keep_away : (body * string) list;
}

let is_relevant = function Irrelevant -> false | Cause | Keeps_away -> true

(* {1 The run once more}

   It makes the events of the story in which no absent body takes part, at their times, and otherwise what
   must happen. *)

type trial = {
  semantics : Semantics.t;
  model : Model.t;
  duration : Rat.t;
  over : bool;  (** that the run ends in a dead end is one of the facts *)
  props : Property.prop list;
  facts : string list;
}
type expected = { label : Transition.label; at : Rat.t; needed : bool }

(* Where the run is: the state, and the transition of this instant that has just led to it. *)
type place = { state : State.t; time : Rat.t; arrival : (State.t * Transition.label) option }

(* What leads nowhere is given up. *)
let patience = 100_000

let facts semantics props place =
  let model = Semantics.model semantics in
  let arrived event =
    match place.arrival with
    | Some (source, label) -> Event.matches ~source label event
    | None -> false
  in
  let trajectory = Trajectory.make ~arrived semantics place.state Timeline.Instant in
  List.concat_map (Facts.every trajectory model Algebraic.zero) props

let pass semantics d (place : place) =
  if Rat.sign d = 0 then place
  else { state = Time.pass semantics d place.state; time = Rat.add place.time d; arrival = None }

let missing w (e : expected) =
  Error
    (Printf.sprintf "%s does not happen at time %s"
       (Transition.label_to_string w.model e.label)
       (Rat.to_string e.at))

(* Whether the run is over, of one whose fact that is. *)
let ending semantics ~over (place : place) =
  let model = Semantics.model semantics in
  match if over then Some (Network.successors semantics place.state) else None with
  | None -> []
  | Some (Error (Persistent_contact firsts)) ->
    let names = List.map (fun leaf -> model.leaves.(leaf).name) firsts in
    [ "the run is over: " ^ String.concat " and " names ^ " are in persistent contact" ]
  | Some (Ok _ | Error (Bad_law _ | Bad_chance _)) -> [ "the run goes on" ]

let all_facts semantics props ~over place = facts semantics props place @ ending semantics ~over place

let compare_end w (place : place) =
  let there = pass w.semantics (Rat.sub w.duration place.time) place in
  let found = all_facts w.semantics w.props ~over:w.over there in
  match List.find_opt (fun (a, b) -> not (String.equal a b)) (List.combine w.facts found) with
  | None -> Ok ()
  | Some (_, b) -> Error (b ^ " at the end")

let make (place : place) (t : Transition.t) =
  match t.label with
  | Time d -> { state = t.target; time = Rat.add place.time d; arrival = None }
  | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _ ->
    { place with state = t.target; arrival = Some (place.state, t.label) }

let is_time (t : Transition.t) = Transition.is_time t.label

let rec follow w place (expected : expected list) fuel =
  if fuel = 0 then Error "the run does not come to its end"
  else
    match (Network.successors w.semantics place.state, expected) with
    | Error (Persistent_contact _), [] when Rat.equal place.time w.duration -> compare_end w place
    | Error (Persistent_contact _), e :: rest when not e.needed -> follow w place rest (fuel - 1)
    | Error fault, _ -> Error ((Transition.diagnostic w.model fault).message)
    | Ok all, e :: rest when Rat.equal e.at place.time -> (
        match List.find_opt (fun (t : Transition.t) -> Transition.equal_label e.label t.label) all with
        | Some t -> follow w (make place t) rest (fuel - 1)
        | None -> if e.needed then missing w e else follow w place rest (fuel - 1))
    | Ok _, [] when Rat.equal place.time w.duration -> compare_end w place
    | Ok all, _ -> onwards w place all expected fuel

(* On to the time of the next expected event, or of the end. *)
and onwards w place all (expected : expected list) fuel =
  let until = match expected with e :: _ -> e.at | [] -> w.duration in
  let undisturbed () =
    match expected with
    | [] -> compare_end w place
    | e :: _ when e.needed -> missing w e
    | _ :: rest -> follow w place rest (fuel - 1)
  in
  (* less than until what comes next, where bonds may be released at any time *)
  let waited =
    match Network.wait w.semantics place.state (Rat.sub until place.time) with
    | Ok taken -> taken
    | Error _ -> None
  in
  match (waited, List.find_opt is_time all, all) with
  | Some t, _, _ -> follow w (make place t) expected (fuel - 1)
  | None, Some t, _ ->
    let next = make place t in
    if Rat.compare next.time until <= 0 then follow w next expected (fuel - 1) else undisturbed ()
  | None, None, t :: _ -> follow w (make place t) expected (fuel - 1)
  | None, None, [] ->
    if Network.quiescent w.semantics place.state then undisturbed () else Error "the run ends too early"

let without (run : Causes.run) absent =
  let stays (p : State.process) =
    not (Array.exists (fun (l : State.leaf) -> Ints.mem l.leaf absent) p.leaves)
  in
  let d = run.declared in
  State.make ~processes:(List.filter stays (Array.to_list d.processes)) ~step:d.step ~time:d.time

let expected_events story roles absent =
  let expect i (e : Causes.event) =
    match e.happening with
    | Discrete label when not (List.exists (fun l -> Ints.mem l absent) e.leaves) ->
      [ { label; at = e.time; needed = is_relevant roles.(i) } ]
    | Discrete _ | Expiry _ -> []
  in
  List.(concat (mapi expect (Array.to_list (Causes.events story))))

let try_without story roles w bodies =
  let absent = Ints.of_list (List.concat bodies) in
  match Network.initial w.semantics (without (Causes.run story) absent) with
  | Error fault -> Error ((Transition.diagnostic w.model fault).message)
  | Ok state ->
    follow w { state; time = Rat.zero; arrival = None } (expected_events story roles absent) patience

(* {1 Who matters} *)

(* As many bodies as can be left out besides [out] (not the most there are: one way of halving is tried), and
   the others with what differs. *)
let rec leave_out attempt out candidates =
  match candidates with
  | [] -> (out, [])
  | _ -> (
      match (attempt (out @ candidates), candidates) with
      | Ok (), _ -> (out @ candidates, [])
      | Error why, [ body ] -> (out, [ (body, why) ])
      | Error _, _ ->
        let half = List.length candidates / 2 in
        let first = List.filteri (fun i _ -> i < half) candidates in
        let second = List.filteri (fun i _ -> i >= half) candidates in
        let out, matter = leave_out attempt out first in
        let out, matter' = leave_out attempt out second in
        (out, matter @ matter'))

let bodies (run : Causes.run) = List.map State.members (Array.to_list run.declared.processes)

let meets leaves list = List.exists (fun l -> Ints.mem l leaves) list

let involved story (basis : Causes.basis) roles keep_away =
  let add found i (e : Causes.event) =
    if is_relevant roles.(i) then Ints.union found (Ints.of_list e.leaves) else found
  in
  let start = Ints.of_list (basis.leaves @ List.concat_map fst keep_away) in
  snd
    (Array.fold_left
       (fun (i, found) e -> (i + 1, add found i e))
       (0, start)
       (Causes.events story))

(* The events in which the bodies met others count, and all that these depend on. *)
let count_in story roles matter =
  let leaves = Ints.of_list (List.concat_map fst matter) in
  let met (e : Causes.event) = meets leaves e.leaves && List.exists (fun l -> not (Ints.mem l leaves)) e.leaves in
  let meetings = Array.map met (Causes.events story) in
  let numbers = List.init (Array.length meetings) Fun.id in
  let causes = Causes.closure story (List.filter (Array.get meetings) numbers) in
  Array.mapi
    (fun i role ->
       match role with
       | Irrelevant when meetings.(i) -> Keeps_away
       | Irrelevant when causes.(i) -> Cause
       | role -> role)
    roles

(* The instant of the fact in the run itself. *)
let final course =
  let legs = Course.legs course in
  let arrival =
    match Array.length legs with
    | 0 -> None
    | n -> (
        let { Course.label; before; _ } = legs.(n - 1) in
        match label with
        | Time _ -> None
        | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _ ->
          Some (before, label))
  in
  { state = Course.last course; time = Rat.sub (Course.duration course) (Course.rest course); arrival }

let explain story (basis : Causes.basis) props =
  let run = Causes.run story and duration = Causes.duration story in
  let semantics = Course.semantics run.course in
  let over = Option.is_some run.over in
  let facts = all_facts semantics props ~over (pass semantics (Course.rest run.course) (final run.course)) in
  let w = { semantics; model = Semantics.model semantics; duration; over; props; facts } in
  let all = bodies run in
  let rec settle roles keep_away =
    let leaves = involved story basis roles keep_away in
    let candidates = List.filter (fun b -> not (meets leaves b)) all in
    match leave_out (try_without story roles w) [] candidates with
    | left_out, [] -> { story; basis; roles; facts; left_out; keep_away }
    | _, matter -> settle (count_in story roles matter) (keep_away @ matter)
  in
  let causes = Causes.closure story (List.map (fun (r : Causes.reason) -> r.cause) basis.reasons) in
  settle (Array.map (fun c -> if c then Cause else Irrelevant) causes) []
