(** States and transitions in words, for people. *)

open Scc_calculus
open Scc_semantics

val label : Model.t -> Transition.label -> string
(** What happens: ["p and q collide and bind by <a, {p.right, q.left}>"]. *)

val state : Model.t -> State.t -> string list
(** A line for each process, and one more for each leaf of a process of several. Long lists and long
    behaviours are cut, and say so. *)

val rounded : Scc_engine.Totals.t * Scc_engine.Totals.t -> string list
(** What rule Round has added to the totals of a network, from close bounds. *)
