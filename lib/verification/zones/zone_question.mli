(** What a check asks of the runs from all starts (rule Starts), as until and means that are explored one by
    one. *)

open Scc_property
open Scc_symbolic

(** A boolean combination of operators of time, each of state predicates, and of state predicates now. *)
type t =
  | Now of Property.prop
  | Not of t
  | All of t list
  | Some_of of t list
  | Operator of operator

and operator = {
  quantifier : Property.path_quantifier;
  until : Chance_claims.question;
  negated : bool;  (** it is asked how likely the until is not *)
}

exception Not_asked of string
(** The reason why something is not known over starts. *)

val of_formula : Property.temporal -> t
(** [of_formula f] is [f] as such a combination. Raises {!Not_asked}. *)

val of_mean : Property.mean -> Chance_claims.question
(** [of_mean mean] is the question for a mean. Raises {!Not_asked}. *)

val untils_of : Property.check -> Chance_claims.question list
(** [untils_of check] are the questions that are explored for a check; none if it asks what is not known. *)
