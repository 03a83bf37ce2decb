open Scc_base
open Scc_exact
open Scc_ctl
open Scc_graph_search
open Scc_state_space
open Scc_explain
open Scc_json

let wrong fmt = Printf.ksprintf (fun text -> Error (Diag.error Code.no_run Span.none "%s" text)) fmt

(* The state that the choices lead to, and when. *)
let follow f choices =
  let context = Filter.context f in
  let rec from tuple arrival n = function
    | [] -> Ok (tuple, arrival)
    | choice :: rest -> (
        match Network_lts.successors context tuple with
        | Error _ -> wrong "the transitions of the state after %d steps cannot be computed" n
        | Ok steps -> (
            match if choice < 0 then None else List.nth_opt steps choice with
            | None -> wrong "step %d: there is no transition %d" (n + 1) choice
            | Some s ->
              let arrival = Rat.add arrival (Network_lts.duration context s.label) in
              from (Tuples.apply s.changes tuple) arrival (n + 1) rest))
  in
  from (Network_lts.initial context) Rat.zero 0 choices

(* Whether it is met in the state, or when after it. *)
let meets f goal tuple arrival : ((Timeline.moment * Algebraic.t) option, Diag.t) result =
  let within = (Filter.question f).goals.(goal).within in
  let is_late = match within with Some bound -> Rat.compare arrival bound > 0 | None -> false in
  let* e = Filter.expand f tuple in
  match (e.state.goals.(goal), e.ahead.(goal)) with
  | True, _ when not is_late -> Ok None
  | (False | Undecided _), Some { met = Some m; _ } when On_the_fly.is_in_time within ~arrival m.moment ->
    Ok (Some (m.moment, On_the_fly.sample_in_time within ~arrival m.moment m.sample))
  | (True | False | Undecided _), _ when is_late -> wrong "the run comes too late for goal %d" goal
  | (True | False | Undecided _), _ -> wrong "the run does not meet goal %d" goal

let rec searches goal : Question.plan -> bool = function
  | Possibly k | Always k -> k = goal
  | All plans | Any plans -> List.exists (searches goal) plans
  | Now _ | Other -> false

let find f ~goal choices =
  let q = Filter.question f in
  match List.find_opt (fun (_, p) -> searches goal p) q.plans with
  | None -> wrong "there is no goal %d" goal
  | Some (check, _) -> (
      let* last, arrival = follow f choices in
      let* during = meets f goal last arrival in
      let w = Make_witness.of_met (Filter.context f) q.goals.(goal).prop { choices; during } in
      match q.exploration.lift w with
      | Some w -> Ok (check, w)
      | None -> wrong "the run meets goal %d later than anything is asked about" goal)

(* The states before and after the round, and how long it takes. *)
let is_round f choices ~from =
  let* before, early = follow f (List.filteri (fun k _ -> k < from) choices) in
  let* after, late = follow f choices in
  Ok (from < List.length choices && before = after && Rat.equal early late)

let cycle f ~from choices =
  let* is_round = is_round f choices ~from in
  if not is_round then wrong "the run does not come back, within one instant, to the state after %d steps" from
  else
    match (Filter.question f).exploration.lift (Make_witness.of_cycle (Filter.context f) choices ~from) with
    | Some w -> Ok w
    | None -> wrong "the run comes back later than anything is asked about"

type request = Goal of int * int list | Cycle of int * int list

let request line =
  let no_json (d : Diag.t) = Diag.error Code.no_run Span.none "%s" d.message in
  let* json = Json.parse (Source.make ~name:"-" line) |> Result.map_error no_json in
  let numbers list = List.map Json.int list in
  let number name = Option.bind (Json.member name json) Json.int in
  match (number "goal", number "cycle", Option.bind (Json.member "choices" json) Json.list) with
  | Some goal, None, Some choices when List.for_all Option.is_some (numbers choices) ->
    Ok (Goal (goal, List.filter_map Fun.id (numbers choices)))
  | None, Some from, Some choices when List.for_all Option.is_some (numbers choices) ->
    Ok (Cycle (from, List.filter_map Fun.id (numbers choices)))
  | _ -> wrong "a run is {\"goal\": a number, \"choices\": [numbers]}, or one with \"cycle\" instead"
