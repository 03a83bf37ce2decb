(** Bonds that close rings (rule Close, reading I-37): an extension of the calculus, for models with
    {!Model.Cyclic}. *)

open Scc_calculus

val all : Semantics.t -> State.process -> Transition.outcome list
(** Every bond that two leaves of a process may make if no bond joins them yet. Each is urgent. The process stays
    one and keeps its motion; its split clock restarts. In all other models the list is empty. *)
