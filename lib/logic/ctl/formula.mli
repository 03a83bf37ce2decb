(** Formulas of timed CTL over numbered predicates. *)

open Scc_exact

(** Over all that can be chosen where nothing is drawn. *)
type side = Least | Greatest

(** Of the probability of the runs of which something is so. *)
type chance = { side : side; test : Scc_chance.Answer.bound }

(** Over runs: all of them, some of them, or as many. *)
type quantifier = All | Exists | Chance of chance

(** Of model time, [[low, high]] or, without [high], [[low, infinity)]; [low] is 0 but for [[a, b]]. *)
type bound = { low : Rat.t; high : Rat.t option }

type t =
  | Predicate of int
  | Not of t
  | And of t list
  | Or of t list
  | Next of quantifier * t
  | Until of quantifier * bound * t * t
  | Finally of quantifier * bound * t
  | Globally of quantifier * bound * t

val compare : t -> t -> int
(** A total order on formulas: structure, with bounds as numbers. *)

val dual : quantifier -> quantifier
(** Q runs satisfy f exactly when it is not so that the dual of Q satisfy "not f". *)

val other_side : side -> side

val chance : chance -> string
(** ["Pmin >= 1/2"]. *)

val compare_quantifier : quantifier -> quantifier -> int
val compare_bound : bound -> bound -> int

val to_string : (int -> string) -> t -> string
(** With the predicates as given; for messages of tests. *)
