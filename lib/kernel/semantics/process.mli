(** What the rules of splits and collisions share: leaves that continue, clocks that are set. *)

open Scc_calculus

val continue : (int * Behaviour.t) list -> State.leaf -> State.leaf
(** [continue continuations l] is [l] with the behaviour that the list has for its index; [l] itself if it has
    none. *)

(** How an end of a bond releases it: what follows, its push (reading I-36), its odds if it is left to chance (rule
    Lot), and the summand. *)
type released = {
  rest : Behaviour.t;
  push : Scc_exact.Rat.t;
  odds : Odds.t option;
  how : Behaviours.derivation;
}

val releases : Model.t -> State.process -> string -> State.finish -> released list
(** [releases m p name f] is the ways in which the end [f] may release a bond of this name: its summands
    omega(a, Phi) that match. *)

val weak_offers : Model.t -> State.process -> State.bond -> (released * released) list
(** The ways to release a bond by free choice: pairs of releases, of its lesser and its greater end. Both ends must
    offer one (reading I-6). *)

val releasable : Model.t -> State.process -> State.bond -> bool
(** [releasable m p b] is true if the bond [b] of [p] may be released by rule WeakSplit, at some split instant. *)

val weak_split_enabled : Model.t -> State.process -> bool
(** [weak_split_enabled m p] is true if a bond of [p] may be released by rule WeakSplit ({!releasable}). *)

val running_clock : Model.t -> State.process -> (Scc_exact.Rat.t * Scc_exact.Rat.t) option
(** [running_clock m p] is the split step and the split clock of [p]; [None] if it has no clock, or one that stands
    still ({!Scc_calculus.Model.Any_time}). *)

val splits_at_any_time : Model.t -> State.process -> bool
(** [splits_at_any_time m p] is true if [p] may release a bond at any time: weak splits are enabled, and are not on
    a grid ({!Scc_calculus.Model.Any_time}). *)

val at_split_instant : State.process -> bool
(** [at_split_instant p] is true if [p] has a split clock and this is at 0, that is at a multiple of the split step
    (reading I-9). Weak splits happen at these instants. *)

val restart_clock : Model.t -> State.process -> State.process
(** The process with its split clock at 0 if a weak split of it is enabled; without a clock otherwise (reading
    I-9). *)

(** {1 Movement steps} *)

val steers : Model.t -> State.process -> bool
(** [steers m p] is true if a leaf of [p] has a law that is not inertial, and no leaf of [p] is fixed (rule
    Steer). *)

val draws : Model.t -> State.process -> bool
(** [draws m p] is true if [p] is steered and a law of it leaves its velocity to chance (rule Draw). *)

val stops : Model.t -> State.process -> bool
(** [stops m p] is true if [p] is a walker that stops where it runs into something (rule Blocked). *)

val yielding_mass : Model.t -> State.process -> Scc_exact.Rat.t option
(** The mass with which [p] takes its share of a bounce: [None] if it takes none, as fixed processes and those do
    that {!stops}. *)

val restart_step : Model.t -> State.process -> State.process
(** The process with its own movement step over, and the time since the last evaluation of laws at 0, if a law
    moves it. Its laws are evaluated next. Where processes have no steps of their own, the process stays as it
    is. *)

val end_step : Model.t -> State.process -> State.process
(** The process after a collision: its own movement step is over, unless it has been steered at this instant
    already. Where processes have no steps of their own, the process stays as it is. *)

val joined_step : Model.t -> State.process -> State.process -> State.process -> State.process
(** [joined_step m p q whole] is [whole], bound from p and q, in its own movement step. The step is over, unless
    each of the two that is steered has been steered at this instant already. Each leaf keeps the time since the
    last evaluation of its law. Where processes have no steps of their own, [whole] stays as it is. *)

val piece_step : Model.t -> whole:State.process -> State.process -> State.process
(** [piece_step m ~whole p] is [p], a piece of [whole], in the movement step of the whole. A steered piece that
    leaves a fixed body is as in {!restart_step}. Where processes have no steps of their own, [p] stays as it is.
*)

(** {1 The order of draws} *)

val by_place : Model.t -> State.process list -> State.process list
(** The processes sorted by the places of their leaves (rule Draw). Leaves compare by the world positions of their
    reference points, then by their orientations, then by the names of their templates. Equal processes keep the
    order of the list. *)

val first_by_place : Model.t -> State.process list -> State.process option
(** The first process in the order of {!by_place}, in linear time; [None] for the empty list. *)

val by_velocity : Model.t -> State.process list -> State.process list
(** The processes sorted by their velocities, and by their places ({!by_place}) where these are equal. *)

val first_by_velocity : Model.t -> State.process list -> State.process option
(** The first process in the order of {!by_velocity} (rule Lot), in linear time; [None] for the empty list. *)
