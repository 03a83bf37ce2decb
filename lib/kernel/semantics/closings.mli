(** Bonds that close rings (rule Close, reading I-37): an extension of the calculus, for models that ask for it. *)

open Scc_calculus

val all : Semantics.t -> State.process -> Transition.outcome list
(** Every bond that two leaves of a process may make which none joins yet. The process stays one and moves on as it
    does; it starts its split clock anew. Urgent. Empty if the model does not have {!Model.Cyclic}. *)
