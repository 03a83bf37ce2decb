(** Bonds that close rings (rule Close, reading I-37): an extension of the calculus, for models with
    {!Scc_calculus.Model.Cyclic}. *)

open Scc_calculus

val may_close : Model.t -> State.process -> bool
(** [may_close m p] is true if rule Close applies to [p] at all: rings may close, and it has three leaves or
    more. *)

val free : State.process -> int -> int -> bool
(** [free p i j] is true if two leaves of [p] are different, and no bond joins them. Only such leaves may close a
    ring. *)

val all : Semantics.t -> State.process -> Transition.outcome list
(** Every bond that two leaves of a process may make if no bond joins them yet. Each is urgent. The process stays
    one and keeps its motion; its split clock restarts. In all other models the list is empty. *)
