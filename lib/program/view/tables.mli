(** The tables of a document, to whose rows its states and runs refer by number. *)

open Scc_calculus
open Scc_semantics

(** The tables. *)
type t = {
  solids : Rows.t;
  behaviours : Rows.t;
  processes : Rows.t;
  labels : Rows.t;
}

val create : unit -> t
(** Empty tables. *)

val process : t -> Semantics.t -> State.process -> int
(** The row of a process: the places of its leaves, their behaviours with the channels that are open, its bonds,
    and its motion from then on. *)

val label : t -> words:(Model.t -> Transition.label -> string) -> Semantics.t -> Transition.label -> int
(** The row of a label. [words] describes it in plain language. *)
