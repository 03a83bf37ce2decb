(** The output of the filter as JSON ([specs/successors.md]). *)

open Scc_base
open Scc_ctl
open Scc_json

(** One of several processes that explore together: which one, from 1, of how many, and where others call it. *)
type owner = { number : int; count : int; port : int }

(** The first line of a session: the exploration, its checks and goals, and its initial state. *)
type header = { program : string; framing : string; owner : owner option; filter : Filter.t }

(** A line of the output. *)
type t =
  | Header of header
  | Answer of Filter.t * Filter.expanded  (** the fingerprint and goals of a state, and its successors *)
  | Run of Scc_property.Property.check * (int * Scc_runs.Schedule.t)  (** a run that shows the verdict *)
  | Cycle of int * (int * Scc_runs.Schedule.t)
  (** a run that comes back within one instant, and how many transitions lead to where it comes back *)
  | Refused of Diag.t  (** the answer to bytes that are no state *)

val format : (t, unit) Json_format.t
(** The format of a line. *)

val line : t -> string
(** The line, without a line end. *)

(** {1 Texts in frames} *)

(** What a frame says about a state beside its numbers. *)
type note = {
  index : int;  (** of the state in the frame *)
  looked : Filter.ahead option array option;  (** the goals ahead *)
  why : Diag.t option;  (** why nothing follows the state *)
  error : Diag.t option;  (** why the bytes are no state *)
}

val moves_text : ((Scc_calculus.Model.t * Filter.label) list * note list, unit) Json_format.t
(** The format of the text of frames about states: labels and notes. *)

val reason : _ Filter.following -> Diag.t option
(** Why nothing follows a state, if there is a reason. *)

val of_moves : Scc_calculus.Model.t -> Filter.label list -> note list -> string
(** The text of new labels and notes. It is empty if there are neither. *)

val targets_text : ((int * Truth.t array) list, unit) Json_format.t
(** The format of the text of frames about targets: their goals, by the index of the target. *)

val of_targets : (int * Truth.t array) list -> string
(** The text of these goals. It is empty if there are none. *)
