open Scc_base
open Scc_ctl
open Scc_graph_search
open Scc_state_space
open Scc_explain
open Scc_json

let wrong fmt = Printf.ksprintf (fun text -> Error (Diag.error Code.no_run Span.none "%s" text)) fmt

let ( let* ) = Result.bind

(* The state that the choices lead to. *)
let follow f choices =
  let context = Filter.context f in
  let rec from tuple n = function
    | [] -> Ok tuple
    | choice :: rest -> (
        match Network_lts.successors context tuple with
        | Error _ -> wrong "the transitions of the state after %d steps cannot be computed" n
        | Ok steps -> (
            match if choice < 0 then None else List.nth_opt steps choice with
            | None -> wrong "step %d: there is no transition %d" (n + 1) choice
            | Some s -> from (Tuples.apply s.changes tuple) (n + 1) rest))
  in
  from (Network_lts.initial context) 0 choices

(* Whether it is met in the state, or when after it. *)
let meets f goal tuple : ((Timeline.moment * Scc_exact.Algebraic.t) option, Diag.t) result =
  let* e = Filter.expand f tuple in
  match (e.state.goals.(goal), e.ahead.(goal)) with
  | True, _ -> Ok None
  | (False | Undecided _), Some { met = Some m; _ } -> Ok (Some (m.moment, m.sample))
  | (False | Undecided _), (None | Some { met = None; _ }) -> wrong "the run does not meet goal %d" goal

let rec searches goal : Question.plan -> bool = function
  | Possibly k | Always k -> k = goal
  | All plans | Any plans -> List.exists (searches goal) plans
  | Now _ | Other -> false

let find f ~goal choices =
  let q = Filter.question f in
  match List.find_opt (fun (_, p) -> searches goal p) q.plans with
  | None -> wrong "there is no goal %d" goal
  | Some (check, _) -> (
      let* last = follow f choices in
      let* during = meets f goal last in
      let w = Make_witness.of_met (Filter.context f) q.goals.(goal).prop { choices; during } in
      match q.exploration.lift w with
      | Some w -> Ok (check, w)
      | None -> wrong "the run meets goal %d later than anything is asked about" goal)

let request line =
  let no_json (d : Diag.t) = Diag.error Code.no_run Span.none "%s" d.message in
  let* json = Json.parse (Source.make ~name:"-" line) |> Result.map_error no_json in
  let numbers list = List.map Json.int list in
  match (Option.bind (Json.member "goal" json) Json.int, Option.bind (Json.member "choices" json) Json.list) with
  | Some goal, Some choices when List.for_all Option.is_some (numbers choices) ->
    Ok (goal, List.filter_map Fun.id (numbers choices))
  | _ -> wrong "a run is {\"goal\": a number, \"choices\": [numbers]}"
