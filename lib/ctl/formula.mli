(** Formulas of timed CTL over numbered predicates. *)

open Scc_exact

type quantifier = All | Exists  (** over runs *)

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

val compare_quantifier : quantifier -> quantifier -> int
val compare_bound : bound -> bound -> int

val to_string : (int -> string) -> t -> string
(** With the predicates as given; for messages of tests. *)
