(** Traces as JSON Lines: one object a line, the same bytes for the same model and choices. *)

open Scc_calculus
open Scc_json

(** A line of a trace. *)
type line

val format : (line, unit) Json_format.t
(** The format of every line. *)

val header : Scc_loading.Origin.t -> Json.t
(** The first line: the model, its parameters and settings, on which the meaning of the choices depends. It does
    not say how the choices were made, so a trace and its replay are the same bytes. *)

val ending_format : (Replay.ending, string) Json_format.t
(** The format of the end of a run, as the word of {!ending}. *)

val ending : Replay.ending -> string
(** The word for the end of a run: ["open"], ["quiescent"], ["stuck"], ["zeno"] or ["interrupted"]. *)

val why : Model.t -> Replay.ending -> (string * Json.t) list
(** The member ["diagnostic"] (SC0602) of a run that is [Stuck], and nothing for any other. *)

(** The states that are written. *)
type states =
  | All  (** the state after each transition *)
  | Ends  (** only the first and the last one, since states dominate the size of a long run of a large network *)

val event : Model.t -> states -> Replay.event -> Json.t list
(** The lines for an event. *)
