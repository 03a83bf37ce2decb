(** The tables of a document, to whose rows its states and runs refer by number. *)

open Scc_calculus
open Scc_semantics
open Scc_json

(** The tables. *)
type t = {
  solids : Rows.t;
  behaviours : Rows.t;
  processes : Rows.t;
  labels : Rows.t;
}

val create : unit -> t
(** Empty tables. *)

val behaviour_format : (Model.t * int * Behaviour.aged, unit) Json_format.t
(** The format of the behaviour of a leaf. *)

type row
(** A process with the rows of its behaviours. *)

val process_format : (row, unit) Json_format.t
(** The format of a process. *)

val label_format : (Model.t * Transition.label * string, unit) Json_format.t
(** The format of a label with its description in plain language. *)

val process : t -> Semantics.t -> State.process -> int
(** The row of a process: the places of its leaves, their behaviours with the channels that are open, its bonds,
    and its motion from then on. *)

val label : t -> words:(Model.t -> Transition.label -> string) -> Semantics.t -> Transition.label -> int
(** The row of a label. [words] describes it in plain language. *)
