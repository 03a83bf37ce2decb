(** The tables of a document that its states and runs speak of by number. *)

open Scc_calculus
open Scc_semantics

type t = {
  solids : Rows.t;
  behaviours : Rows.t;
  processes : Rows.t;
  labels : Rows.t;
}

val create : unit -> t

val process : t -> Semantics.t -> State.process -> int
(** A process as it is: its leaves where they are, their behaviours with the channels that are open, its bonds, and
    how it moves from then on. *)

val label : t -> words:(Model.t -> Transition.label -> string) -> Semantics.t -> Transition.label -> int
(** [words] tells it to a person. *)
