(** Splits of one process (rules WeakSplit and StrongSplit). The pieces keep the motion of the whole
    (readings I-11 and I-23); each starts its split clock anew. *)

open Scc_calculus

val weak : Semantics.t -> State.process -> Transition.outcome list
(** Rule WeakSplit: every release of one bond that may happen at this instant, that is when the split clock
    is at a multiple of the split step, or at any instant ({!Model.Any_time}; readings I-6, I-9). *)

val lots : Semantics.t -> Lots.due -> (Transition.outcome list, Transition.fault) result
(** Rule Lot, while lots are pending: what may be decided of the next bond, with the probabilities, or how the
    bonds are released of which that is decided. Nothing else may happen. *)

val strong : Semantics.t -> State.process -> Transition.outcome list
(** Rule StrongSplit: every reaction of a connected set of bonds (reading I-7). Urgent. *)
