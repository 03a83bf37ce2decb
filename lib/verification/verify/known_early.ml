open Scc_exact
open Scc_calculus
open Scc_property
open Scc_graph_search
open Scc_state_space

let formulas = Temporal.formulas

let start (s : State.t) = Option.value s.time ~default:Rat.zero

let horizon model ~initial checks =
  let from = start initial in
  match checks with
  | [] -> None
  | _ :: _ -> Option.map (fun time -> Rat.sub time from) (Settling.of_checks model ~from checks)

let within model ~initial bound goal =
  match Settling.prop model goal with
  | Some { after; truth = false } -> Option.merge Rat.min bound (Some (Rat.sub after (start initial)))
  | Some { truth = true; _ } | None -> bound

type question = { asked : Property.asked; formula : int }

(* A number is what it will be once no state that was not expanded matters to it. *)
let is_settled temporal { asked; formula } =
  let explored (d : Scc_ctl.Doubts.t) = d.unexplored = [] in
  match asked with
  | Whether -> Option.is_some (Formulas.truth (formulas temporal) formula)
  | How_likely _ -> explored (Formulas.possible_doubts (formulas temporal) formula)
  | Expected (_, (Time_until _ | Events_until _), _) ->
    explored (Formulas.doubts_of_mean (formulas temporal) formula)
  | Expected (sides, (Value_at _ as mean), _) ->
    let is_known side =
      match Formulas.mean (formulas temporal) formula side mean with
      | Known _ | Unknown { unexplored = []; _ } -> true
      | Unknown _ -> false
    in
    List.for_all is_known sides

(* What is settled stays so as the graph grows. *)
let settled (around : Limits.surroundings) formulas ~rests questions =
  let rec unsettled temporal = function
    | q :: rest when is_settled temporal q -> unsettled temporal rest
    | left -> left
  in
  let left = ref questions in
  let look g () =
    left := unsettled (Temporal.on formulas ~rests g) !left;
    !left = []
  in
  match questions with
  | [] -> None
  | _ :: _ -> Some (fun g -> Result.value (around.attempt.run Exploring (look g)) ~default:false)
