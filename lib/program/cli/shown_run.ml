open Scc_exact
open Scc_calculus
open Scc_loading
open Scc_runs
open Scc_view

type simulated = { until : Rat.t; most_steps : int; mutable steps : int }

(* A run that is interrupted is shown as far as it came, and so is one that was given up, unless it was asked for:
   the checks may be decided before. *)
let ended (l : Loaded.t) (policy : Replay.policy) = function
  | Ok ending -> Ok ending
  | Error (Replay.Interrupted _) -> Ok Replay.Open
  | Error (Refused d) -> Error [ d ]
  | Error (Fault f) -> (
      match policy with
      | First | Random _ -> Ok (Stuck f)
      | Scheduled _ -> Error [ Replay.diagnostic l.model f ])

let replay (l : Loaded.t) simulated policy limits ~interrupted (note : Replay.event -> unit) =
  let counted (event : Replay.event) =
    (match (event, simulated) with
     | Step _, Some s -> s.steps <- s.steps + 1
     | (Start _ | Step _ | Instant _ | End _), _ -> ());
    note event
  in
  let enough () = match simulated with Some s -> s.steps >= s.most_steps | None -> false in
  let interrupted () = enough () || interrupted () in
  ended l policy
    (Replay.run ~joint:(Option.is_some simulated) l.semantics l.declared policy limits ~interrupted counted)

let told (l : Loaded.t) (e : Replay.ending) =
  match e with
  | Open -> []
  | Quiescent -> [ "nothing happens any more" ]
  | Zeno -> [ "the run was stopped: it went on within one instant" ]
  | Broken_off -> [ "the run was interrupted" ]
  | Stuck f -> [ (Replay.diagnostic l.model f).message ]

let ending = told

type t = { initial : State.t; steps : Runs.step list; offset : Rat.t; ending : Replay.ending; words : string list }

let follow (l : Loaded.t) simulated policy limits ~too_long ~interrupted =
  let initial = ref l.declared and steps = ref [] and offset = ref Rat.zero and long = ref false in
  let note : Replay.event -> unit = function
    | Start s -> initial := s
    | Step { index; among; taken; state; _ } ->
      let choice = if index < among then Some index else None in
      let after = state () in
      if too_long after then long := true;
      steps := { Runs.choice; label = taken.label; rules = taken.rules; after } :: !steps
    | Instant i -> offset := i.offset
    | End _ -> ()
  in
  let interrupted () = !long || interrupted () in
  let* ending = replay l simulated policy limits ~interrupted note in
  let words = if !long then [ "it is not followed further: its numbers become too long" ] else told l ending in
  Ok { initial = !initial; steps = List.rev !steps; offset = !offset; ending; words }
