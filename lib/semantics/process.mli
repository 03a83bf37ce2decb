(** What the rules of splits and collisions share: leaves that continue, clocks that are set. *)

open Scc_calculus

val continue : (int * Behaviour.t) list -> State.leaf -> State.leaf
(** The leaf with the behaviour that the list gives for it, if it gives one. *)

val weak_offers : Model.t -> State.process -> State.bond -> (Behaviour.t * Behaviour.t * Rule.t list) list
(** The ways to release a bond, which both its ends must offer (reading I-6): what its lesser and its
    greater end become, and the behaviour rules used. *)

val weak_split_enabled : Model.t -> State.process -> bool
(** Whether some bond may be released by rule WeakSplit. *)

val at_split_instant : State.process -> bool
(** Whether a weak split of it may happen now: its clock is at a multiple of the split step (reading I-9). *)

val restart_clock : Model.t -> State.process -> State.process
(** The process with its split clock at 0 if a weak split of it is enabled, without clock otherwise
    (reading I-9). *)

val rules : Rule.t -> Behaviours.derivation -> Rule.t list
(** A prefix's rule with Sum and Def where the derivation used them. *)

val union : Rule.t list -> Rule.t list -> Rule.t list
(** Both, without repetition, in the order of {!Rule.all}. *)
