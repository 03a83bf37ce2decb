(** Timed CTL by the definition, on points and open intervals with a clock beside: slow, and shares nothing with
    the evaluator but the syntax. *)

open Scc_ctl

type t

val make : Small.t -> t

(** Whether it holds for certain, and whether it may hold. *)
type answer = { surely : bool; perhaps : bool }

val node : t -> Formula.t -> int -> answer
val cell : t -> Formula.t -> int -> int -> answer
(** In a cell of the flow of a node. *)

(** {1 Means} *)

val time_until : t -> Formula.side -> Formula.t -> Scc_chance.Answer.t * Scc_chance.Answer.t
(** From node 0 on: with all that may end it, and with what surely does. *)

val changes_until : t -> Formula.side -> Formula.t -> Formula.t -> Scc_chance.Answer.t * Scc_chance.Answer.t

type mean = Never_decided | Is of Scc_chance.Answer.t

val value_at : t -> Formula.side -> (int -> Scc_exact.Rat.t -> Scc_exact.Rat.t) -> int -> mean
(** Of a number that is not negative, at a time in halves of the unit. *)
