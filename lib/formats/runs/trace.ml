open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_engine
open Scc_json
open Json_format

type states = All | Ends

(* {1 The format} *)

type stretch = { offset : Rat.t; reached : Rat.t; there : State.t }
type finish = { steps : int; time : Rat.t; ending : Replay.ending; rounded : (Totals.t * Totals.t) option }

(* What is after a transition, unless only the ends are written. *)
type after = { added : Totals.t option; state : State.t }
type step = { number : int; index : int; among : int; time : Rat.t; taken : Run.alternative; after : after option }

type line =
  | Header of Scc_loading.Origin.t
  | State of Model.t * Rat.t * State.t
  | Transition of Model.t * step
  | Instant of Model.t * stretch
  | End of Model.t * finish

let header_members =
  all
    [
      fixed "format" (`String "scc-trace");
      field "version" (one_of Schedule.versions) Schedule.version
        ~about:"2 where bonds may be released at any time (split_step any), else 1.";
      Shared.semantics ();
      Origin_json.fields;
    ]

let state_members =
  all
    [
      field "time" Shared.rational (fun (_, time, _) -> time);
      field "state" State_json.state_format (fun (m, _, s) -> (m, s));
    ]

let totals =
  fields
    [
      field "momentum" Shared.vector (fun (t : Totals.t) -> t.momentum);
      field "angular" Shared.vector (fun (t : Totals.t) -> t.angular) ~about:"Angular momentum about the origin.";
      field "energy" Shared.rational (fun (t : Totals.t) -> t.energy) ~about:"Kinetic.";
    ]
  |> about "Of all that is not fixed." |> named ~file:"trace" "totals"

let transition_members =
  let rules s = List.map Rule.id s.taken.rules in
  all
    [
      field "step" Shared.from_one (fun (_, s) -> s.number) ~about:"From 1.";
      field "choice" natural (fun (_, s) -> s.index) ~about:"Its number among those possible, from 0.";
      field "of" Shared.from_one (fun (_, s) -> s.among) ~about:"How many were possible.";
      field "label" State_json.label_format (fun (m, s) -> (m, s.taken.label));
      field "rules" (list ~least:1 some_text) (fun (_, s) -> rules s)
        ~about:"The rules that made it, the network's rule first.";
      field "time" Shared.rational (fun (_, s) -> s.time) ~about:"Model time after it.";
      maybe "rounded" totals (fun (_, s) -> Option.bind s.after (fun a -> a.added))
        ~about:"What rounding added to the totals of the network, exactly; with the state only.";
      maybe "state" State_json.state_format (fun (m, s) -> Option.map (fun a -> (m, a.state)) s.after)
        ~about:"After it; none with --states=ends.";
    ]

let instant_members =
  all
    [
      field "offset" Shared.rational (fun (_, i) -> i.offset);
      field "time" Shared.rational (fun (_, i) -> i.reached);
      field "state" State_json.state_format (fun (m, i) -> (m, i.there));
    ]

let ending : Replay.ending -> string = function
  | Open -> "open"
  | Quiescent -> "quiescent"
  | Stuck _ -> "stuck"
  | Zeno -> "zeno"
  | Broken_off -> "interrupted"

let diagnostic m : Replay.ending -> _ = function
  | Stuck given_up -> Some ((fun _ -> None), Replay.diagnostic m given_up)
  | Open | Quiescent | Zeno | Broken_off -> None

let diagnostic_member =
  maybe "diagnostic" Diag_json.format (fun (m, e) -> diagnostic m e) ~about:"With stuck: why and where (SC0602)."

let ending_format =
  word Fun.id [ "open"; "quiescent"; "stuck"; "zeno"; "interrupted" ]
  |> from ending
  |> about
    "stuck: a dead end, in which the run is over. interrupted: by a signal, and nothing is said of what follows."

let end_members =
  let bounds = fields [ field "low" totals fst; field "high" totals snd ] in
  all
    [
      field "steps" natural (fun (_, e) -> e.steps);
      field "time" Shared.rational (fun (_, (e : finish)) -> e.time)
        ~about:"At which the run is left: of the last transition, or of the instant after it that is told.";
      field "ending" ending_format (fun (_, e) -> e.ending);
      within (fun (m, e) -> (m, e.ending)) diagnostic_member;
      maybe "rounded" bounds (fun (_, e) -> e.rounded)
        ~about:"Of a model that rounds: close bounds on what rounding has added to the totals of the network.";
    ]

let format =
  tagged "type"
    [
      variant "header" (function Header o -> Some o | _ -> None) header_members Fun.id;
      variant "state" (function State (m, time, s) -> Some (m, time, s) | _ -> None) state_members Fun.id
        ~about:"The initial state; and the last one, when the transitions have none (--states=ends).";
      variant "transition" (function Transition (m, s) -> Some (m, s) | _ -> None) transition_members Fun.id;
      variant "instant" (function Instant (m, i) -> Some (m, i) | _ -> None) instant_members Fun.id
        ~about:"Where the run is left between two events: offset of time after the last transition.";
      variant "end" (function End (m, e) -> Some (m, e) | _ -> None) end_members Fun.id;
    ]

(* {1 Lines} *)

let line = write format
let header origin = line (Header origin)
let why m e = written_members diagnostic_member (m, e)

let event (m : Model.t) states (e : Replay.event) =
  match e with
  | Start s -> [ line (State (m, Rat.zero, s)) ]
  | Step { number; index; among; time; taken; state; _ } ->
    let after =
      match states with
      | All -> Some { added = Option.map Lazy.force taken.rounded; state = state () }
      | Ends -> None
    in
    [ line (Transition (m, { number; index; among; time; taken; after })) ]
  | Instant { offset; time; state } -> [ line (Instant (m, { offset; reached = time; there = state })) ]
  | End { steps; time; ending; last; rounded } ->
    let last =
      match (states, last) with
      | Ends, Some s when steps > 0 -> [ line (State (m, time, s ())) ]
      | (All | Ends), _ -> []
    in
    last @ [ line (End (m, { steps; time; ending; rounded })) ]
