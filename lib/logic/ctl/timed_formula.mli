(** Formulas of timed CTL over numbered predicates. *)

open Scc_exact

(** The least or the greatest value over all schedulers. *)
type side = Least | Greatest

(** A test of the least or the greatest probability of the runs that satisfy a formula. *)
type chance = { side : side; test : Scc_chance.Answer.bound }

(** Quantifiers over runs: all runs, some run, or a test of their probability. *)
type quantifier = All | Exists | Chance of chance

(** An interval of model time from [low] to [high], both included; without [high] it has no end. [low] is 0 unless
    the bound is written [a, b]. *)
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
(** A total order on formulas by their structure; bounds are compared as numbers. *)

val dual : quantifier -> quantifier
(** [dual q] is the quantifier such that q runs satisfy f iff not (dual q) runs satisfy "not f". *)

val other_side : side -> side
(** [other_side side] is [Greatest] for [Least], and [Least] for [Greatest]. *)

val chance : chance -> string
(** [chance c] is the text of the test, such as ["Pmin >= 1/2"]. *)

val compare_quantifier : quantifier -> quantifier -> int
(** A total order on quantifiers. *)

val compare_bound : bound -> bound -> int
(** A total order on bounds: by [low], then by [high], with [None] first. *)

val to_string : (int -> string) -> t -> string
(** [to_string name f] is the text of [f], with [name p] for predicate [p]; for messages of tests. *)
