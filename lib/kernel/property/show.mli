(** Properties as text, with the names of a model: for reports and witnesses. What was written in a model
    file is printed by the printer of the syntax; here quantifiers are expanded and names resolved. *)

open Scc_calculus

val event : Model.t -> Property.event -> string
(** [bind(a, p, q)], [bounce]. *)

val num : Model.t -> Property.num -> string
(** [x(p)], [bonds(a, p, q)], [(x(p) + 1)]: fully bracketed. *)

val prop : Model.t -> Property.prop -> string

val temporal : Model.t -> Property.temporal -> string
(** As one would write it, with as few brackets as can be; a disjunction of two that begins with a negation is an
    implication. *)

val atoms : Property.prop -> Property.prop list
(** The predicates under the connectives, without repetition, in order: those whose truth explains the
    whole. *)
