(** Goals that are searched for in the order of time. *)

open Scc_exact
open Scc_ctl

(** What is known of a goal: the same at all owners, but for the doubts. *)
type goal = {
  within : Rat.t option;  (** the time up to which it counts *)
  mutable met : Round.event option;  (** at the earliest moment that is known *)
  mutable decided : bool;  (** no earlier moment can come *)
  mutable doubtful : bool;  (** it is undecided in some state of this owner, in time *)
}

val goal : Rat.t option -> goal
(** A goal with a bound, of which nothing is known. *)

val attained : Rat.t -> Timeline.moment
(** The moment of a state that is reached at this time. *)

val counts : goal -> Rat.t -> bool
(** [counts goal time] is true if a state that is reached at this time may meet the goal. *)

val asks : Rat.t -> goal -> bool
(** [asks time goal] is true if states that are reached at this time matter to the goal. *)

val decide : goal array -> Rat.t -> Round.t -> int option
(** [decide goals now round] decides what a round of states that are reached at [now] decides. The result is the
    last turn with which one of the goals was decided. *)
