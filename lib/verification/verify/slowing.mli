(** Event times that grow ever slower, as in a run in which they converge (rule Run). It is an observation of a
    part of the run, in an exploration that a bound has ended, and proves nothing. *)

open Scc_exact
open Scc_state_space

type stretch = { instants : int; took : Rat.t }

type t = {
  stretches : stretch list;  (** three, each of twice as many instants as the one before *)
  until : Rat.t;  (** the last instant *)
}

val find : State_graph.t -> t option
(** The slowing along the shortest path to the deepest state that a bound left unexpanded. The instants at
    which its states begin are compared. The second half took at most 3/4 of the time of the quarter before,
    and that at most 3/4 of the time of the eighth before it. That is so if gaps fall as 1/n^2, or faster, and
    not if they fall as 1/n. *)

val deepest : State_graph.t -> int option
(** The deepest state that a bound left unexpanded, the first of them. Bounds of time, and the guard for one
    instant, do not count. *)

val of_instants : Rat.t list -> t option
(** The slowing in a list of instants, in order, as in {!find}; [None] if there are fewer than 25 distinct
    ones. *)

val to_string : t -> string
(** The stretches as a sentence, with durations to three digits. *)
