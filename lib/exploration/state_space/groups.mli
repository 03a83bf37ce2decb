(** Processes that may act on each other without time passing: those whose boxes meet, directly or through
    others. The events of an instant in one group do not change the possible events in another, since nothing
    moves. Bodies that do not touch now do not touch before time passes. Splits and bindings concern one group.
*)

open Scc_calculus
open Scc_semantics

type t

val of_processes : Semantics.t -> State.process array -> t
(** The groups of all processes of a state. *)

val of_leaf : t -> int -> int
(** The number of the group of the process that has the leaf. It is a bug if no process has it. *)

val leaves : t -> int -> int list
(** The indices of the leaves of all processes in the group with this number. *)
