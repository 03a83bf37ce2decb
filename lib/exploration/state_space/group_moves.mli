(** What one group of processes does of all that happens at an instant (rule Order). *)

open Scc_calculus
open Scc_semantics

val first_hidden :
  Semantics.t -> (int -> bool) -> State.process array -> Local.move Network.discrete ->
  Local.move Network.discrete option
(** [first_hidden c visible processes d] is the transitions of the first group of [processes] that has something
    urgent to do and has no visible leaf. It is [None] if there is no such group, or if no other group could act as
    well. *)
