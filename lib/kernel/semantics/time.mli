(** Rule Time: how far time passes, and what it does. *)

open Scc_exact
open Scc_calculus

val delay : Semantics.t -> State.t -> Rat.t option
(** For a state in which time may pass: the least of the time left in the movement step (if there are steps:
    rule Jump), Ftoc, the horizons of the behaviours and the times to the next split instants. [None] when
    none of them is finite, or when only movement steps are left that nothing steers any more: the network is
    quiescent, unless a weak split may still happen at any time ({!Model.Any_time}), for which time never stops. *)

val pass : Semantics.t -> Rat.t -> State.t -> State.t
(** The state after a time d > 0 that is at most {!delay}, or any where that is [None] (in which what spins goes
    on from step to step: it takes as long); split clocks run modulo the split step (reading I-16). *)

val step_left : Model.t -> State.t -> Rat.t option
(** The time left in the first movement step that ends: that of the network, or of a process. *)

(** {1 One process} *)

val horizon : Model.t -> State.process -> Rat.t option
(** The least horizon of its behaviours. *)

val to_split_instant : Model.t -> State.process -> Rat.t option
(** The time to its next split instant, if a weak split of it is enabled, and bonds are released on a grid. *)

val wait : Model.t -> State.process -> Rat.t option
(** The lesser of the two: the time until something may happen to it by itself. *)

val gains_split : Model.t -> State.process -> State.process -> bool
(** [gains_split m p aged]: whether a bond of p may be released by a weak split in [aged], which p has become as
    time passed, and could not before (reading I-9). *)

val age_process : Model.t -> Rat.t -> State.process -> State.process
(** What {!pass} does to behaviours and split clock, for 0 <= d up to {!wait}. *)

val pass_process : Model.t -> Rat.t -> State.process -> State.process
(** What {!pass} does to it as long as no turn begins, for 0 <= d up to {!wait}. *)
