(** Means by the definition. *)

open Scc_ctl

val time_until : Naive.t -> Timed_formula.side -> Timed_formula.t -> Scc_chance.Answer.t * Scc_chance.Answer.t
(** From node 0 on: with all that may end it, and with what surely does. *)

val counts_until :
  Naive.t ->
  Timed_formula.side ->
  (int -> int -> int * int) ->
  Timed_formula.t ->
  Scc_chance.Answer.t * Scc_chance.Answer.t
(** Of what is counted on each edge of a node, at least and at most. *)

type mean = Never_decided | Is of Scc_chance.Answer.t

val value_at : Naive.t -> Timed_formula.side -> (int -> Scc_exact.Rat.t -> Scc_exact.Rat.t) -> int -> mean
(** Of a number that is not negative, at a time in halves of the unit. *)
