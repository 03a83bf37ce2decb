(** Formulas of timed CTL over numbered predicates. *)

open Scc_property

type t =
  | Predicate of int
  | Not of t
  | And of t list
  | Or of t list
  | Next of Property.path_quantifier * t
  | Until of Property.path_quantifier * Property.bound * t * t
  | Finally of Property.path_quantifier * Property.bound * t
  | Globally of Property.path_quantifier * Property.bound * t

val compare : t -> t -> int
(** A total order on formulas: structure, with bounds as numbers. *)

val of_temporal : Property.temporal list -> t list * Property.prop array
(** The same formulas over the state predicates that occur in them, equal ones shared. *)

val to_temporal : (int -> Property.prop) -> t -> Property.temporal
(** Back, with the predicates as given. *)

val to_string : (int -> string) -> t -> string
(** With the predicates as given; for messages of tests. *)
