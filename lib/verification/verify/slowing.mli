(** Event times that grow ever slower: what a run in which they converge looks like from a part of it (rule
    Run). It is said of an exploration that a bound has ended, and proves nothing. *)

open Scc_exact
open Scc_state_space

type stretch = { instants : int; took : Rat.t }

type t = {
  stretches : stretch list;  (** three, each of twice as many instants as the one before *)
  until : Rat.t;  (** the last instant *)
}

val find : State_graph.t -> t option
(** Along the shortest path to the deepest state that a bound left unexpanded: when of the instants at which its
    states begin the second half took at most 3/4 of the time of the quarter before, and that at most 3/4 of the
    time of the eighth before it. So it is where gaps fall as 1/n^2, or faster, and not where they fall as 1/n.
*)

val deepest : State_graph.t -> int option
(** The deepest state that a bound left unexpanded, the first of them. *)

val of_instants : Rat.t list -> t option
(** The same of instants that are given, in order. *)

val to_string : t -> string
(** With durations to three digits. *)
