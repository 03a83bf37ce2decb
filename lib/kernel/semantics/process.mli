(** What the rules of splits and collisions share: leaves that continue, clocks that are set. *)

open Scc_calculus

val continue : (int * Behaviour.t) list -> State.leaf -> State.leaf
(** The leaf with the behaviour that the list gives for it, if it gives one. *)

(** What an end of a bond becomes when it releases it, by which summand, how hard it pushes (reading I-36), and how
    likely, if it is not free to choose (rule Lot). *)
type released = {
  rest : Behaviour.t;
  push : Scc_exact.Rat.t;
  odds : Odds.t option;
  how : Behaviours.derivation;
}

val releases : Model.t -> State.process -> string -> State.finish -> released list
(** What an end of a bond of this name may do to release it: its summands omega(a, Phi) that match. *)

val weak_offers : Model.t -> State.process -> State.bond -> (released * released) list
(** The ways to release a bond by free choice, which both its ends, the lesser and the greater, must offer
    (reading I-6). *)

val releasable : Model.t -> State.process -> State.bond -> bool
(** Whether a bond may be released by rule WeakSplit, at some instant. *)

val weak_split_enabled : Model.t -> State.process -> bool
(** Whether some bond may be released by rule WeakSplit. *)

val at_split_instant : State.process -> bool
(** Whether a weak split of it may happen now: its clock is at a multiple of the split step (reading I-9). *)

val restart_clock : Model.t -> State.process -> State.process
(** The process with its split clock at 0 if a weak split of it is enabled, without clock otherwise
    (reading I-9). *)

(** {1 Movement steps} *)

val steers : Model.t -> State.process -> bool
(** Whether a law that is not inertial moves this process: not when it is bound to a fixed leaf. *)

val draws : Model.t -> State.process -> bool
(** Whether it is steered and a law of it leaves its velocity to chance (rule Draw). *)

val restart_step : Model.t -> State.process -> State.process
(** The process about to be steered for the first time, if a law moves it; in this and what follows nothing is
    changed where processes have no steps of their own. *)

val end_step : Model.t -> State.process -> State.process
(** A collision ends its movement step, unless it has been steered at this instant already. *)

val joined_step : Model.t -> State.process -> State.process -> State.process -> State.process
(** [joined_step m p q whole]: the same of a whole of p and q. How long ago its laws were asked each leaf
    remembers. *)

val piece_step : Model.t -> whole:State.process -> State.process -> State.process
(** A piece goes on in the step of the whole; one that leaves a fixed body is about to be steered. *)

(** {1 Whose turn it is to draw} *)

val by_place : Model.t -> State.process list -> State.process list
(** By their leaves: by the reference points of these, then by how they are turned, then by the names of their
    templates; those that are alike stay in the order of the list (rule Draw). *)

val first_by_place : Model.t -> State.process list -> State.process option
(** The first one of them. *)

val by_velocity : Model.t -> State.process list -> State.process list
(** By their velocities, and those with one velocity by place (rule Lot). *)

val first_by_velocity : Model.t -> State.process list -> State.process option
(** The first one of them. *)
