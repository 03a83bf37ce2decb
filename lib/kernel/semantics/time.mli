(** Rule Time: how far time passes, and what it does. *)

open Scc_exact
open Scc_calculus

val delay : Semantics.t -> State.t -> Rat.t option
(** How far time passes from a state in which it may pass. It is the least of these times:
    - the time left in the movement step, if there are steps (rule Jump);
    - the time left in the turns of what spins;
    - the time of the next contact (rule Ftoc);
    - the horizons of the behaviours;
    - the times to the next split instants, and to the next lots.

    The result is [None] if none of them is finite. It is also [None] if only movement steps and turns are left,
    with nothing steered, no contact ahead and nothing to round. Then the network is quiescent, unless bonds may
    be released at any time ({!Scc_calculus.Model.Any_time}), where time never stops for a weak split. *)

val pass : Semantics.t -> Rat.t -> State.t -> State.t
(** [pass c d s] is the state after a time d > 0 that is at most {!delay}, or after any d > 0 if that is [None].
    Split clocks run modulo the split step (reading I-16). The computation goes from turn to turn: its length
    grows with the number of turns within d. *)

val step_left : Model.t -> State.t -> Rat.t option
(** The time left in the first movement step that ends: that of the network, or of a process. [None] if there are
    no steps. *)

(** {1 One process} *)

val horizon : Model.t -> State.process -> Rat.t option
(** The least horizon of the behaviours of a process, at which an eps expires; [None] if no eps is exposed. *)

val to_split_instant : Model.t -> State.process -> Rat.t option
(** The time to the next split instant of a process. [None] if no weak split of it is enabled, or if bonds are not
    released on a grid ({!Scc_calculus.Model.Any_time}). *)

val wait : Model.t -> State.process -> Rat.t option
(** The least of {!horizon}, {!to_split_instant} and {!Lots.wait}: the time until the process may change by itself,
    apart from its motion. *)

val gains_split : Model.t -> State.process -> State.process -> bool
(** [gains_split m p aged] is true if a weak split may release a bond in [aged] that it could not release in [p].
    [aged] is [p] after time has passed. Then the split clock restarts (reading I-9). *)

val age_process : Model.t -> Rat.t -> State.process -> State.process
(** [age_process m d p] is [p] with behaviours, split clock and lots as {!pass} leaves them, for 0 <= d up to
    {!wait}. It does not move. *)

val pass_process : Model.t -> Rat.t -> State.process -> State.process
(** [pass_process m d p] is [p] moved and aged as {!pass} leaves it, for 0 <= d up to {!wait} and up to the end
    of its present turn. *)
