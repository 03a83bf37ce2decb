(** The state predicates of a model's checks, for tools that know of labels only. *)

open Scc_calculus
open Scc_property

type t = {
  name : string;  (** see {!Safe_names} *)
  text : string;
  prop : Property.prop;
}

val reserved : string list
(** The labels that every graph has: [init], [deadlock] (nothing can happen, not even the passing of time),
    [quiescent] (nothing will ever happen again, and time passes for ever), [unexplored] (what comes next was not
    explored) and [right_after] (a stretch of time that does not contain its first instant, see {!Labelling}). *)

val of_checks : Model.t -> Property.check list -> t list
(** Each atomic predicate but [quiescent] once, in the order of the text, then the greatest state predicates
    of each check: [check_NAME], and [check_NAME_2] for its second one. Predicates about transitions ([event])
    are none about states and are left out. *)

(** What a check wants of states by themselves. *)
type aim =
  | Reached of Property.prop  (** it asks for a state with this: EF, AF *)
  | Kept of Property.prop  (** it asks for all states to have this: AG *)

val aims : Property.check list -> (string * aim) list
(** By check; none for those of another form, nor for those with a bound of time, since a state does not tell
    the time. *)
