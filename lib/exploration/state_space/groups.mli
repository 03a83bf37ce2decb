(** Processes that may act on each other without time passing: those whose boxes meet, directly or through
    others. What happens within an instant in one group does not change what can happen in another, since
    nothing moves: bodies that do not touch now do not touch before time passes, and splits and bindings concern
    one group. *)

open Scc_calculus
open Scc_semantics

type t

val of_processes : Semantics.t -> State.process array -> t

val of_leaf : t -> int -> int
(** The group of the process that has the leaf. *)

val leaves : t -> int -> int list
(** Of all the processes of a group. *)
