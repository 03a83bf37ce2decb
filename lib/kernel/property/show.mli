(** Properties as text, with the names of a model: for reports and witnesses. Quantifiers are expanded and names
    resolved; the printer of the syntax prints what was written in a model file. *)

open Scc_calculus

val event : Model.t -> Property.event -> string
(** An event as text: [bind(a, p, q)], [bounce]. *)

val num : Model.t -> Property.num -> string
(** A number as text, fully bracketed: [x(p)], [bonds(a, p, q)], [(x(p) + 1)]. *)

val prop : Model.t -> Property.prop -> string
(** A state predicate as text. Nested conjunctions and disjunctions have brackets. *)

val temporal : Model.t -> Property.temporal -> string
(** A formula as text, with as few brackets as possible. A disjunction of two that begins with a negation is
    printed as an implication. *)

val atoms : Property.prop -> Property.prop list
(** The predicates under the connectives, in order and without repetition. The truth of the whole follows from
    theirs. *)
