(** Traces as JSON Lines: one object a line, the same bytes for the same model and choices. *)

open Scc_calculus

val header : Scc_session.Origin.t -> Json.t
(** The first line: what the run is of. It holds what decides what the choices mean, and not how they were
    made, so that a trace and its replay are the same bytes. *)

val ending : Replay.ending -> string
(** ["open"], ["quiescent"], ["stuck"] or ["zeno"]. *)

val why : Model.t -> Replay.ending -> (string * Json.t) list
(** Of a run that is [Stuck], the member ["diagnostic"], SC0602; nothing of another. *)

(** Which states are written. *)
type states =
  | All  (** the state after each transition *)
  | Ends  (** only the first and the last one: what a long run of a large network costs is then in its events *)

val event : Model.t -> states -> Replay.event -> Json.t list
(** The lines for an event. *)
