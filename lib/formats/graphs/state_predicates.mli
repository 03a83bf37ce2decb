(** The state predicates of a model's checks, for tools that know labels only. *)

open Scc_calculus
open Scc_property

(** A predicate with its label. *)
type t = {
  name : string;  (** its label, by {!Safe_names} *)
  text : string;
  prop : Property.prop;
}

val reserved : string list
(** The labels of every graph. [init]: the initial state. [deadlock]: nothing can happen, not even the passing
    of time. [quiescent]: nothing will ever happen again, and time passes for ever. [unexplored]: the successors
    were not explored. [right_after]: a stretch of time without its first instant, see {!Labelling}. *)

val of_checks : Model.t -> Property.check list -> t list
(** The atomic predicates except [quiescent], each once, in the order of the text. Then follow the greatest
    state predicates of each check: [check_NAME], and [check_NAME_2] for its second one. Predicates about
    transitions ([event]) are left out, since they are not about states. *)

(** What a check requires of states by themselves. *)
type aim =
  | Reached of Property.prop  (** some state has this: EF, AF *)
  | Kept of Property.prop  (** all states have this: AG *)

val aims : Property.check list -> (string * aim) list
(** The aims of checks, by name. A check of another form has none. Neither has one with a bound of time, since a
    state does not contain the time. *)
