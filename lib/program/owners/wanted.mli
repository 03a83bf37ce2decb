(** The properties of an exploration that are more than searches for a state, and what has to be known of states
    for them. All owners find the same. *)

open Scc_property
open Scc_state_space

(** One of them. *)
type check = {
  place : int;  (** its place among the checks of the header *)
  check : Property.check;
  plan : Plan.t;
  first : int;  (** the index of the first formula of the plan; the others follow *)
}

type t = {
  checks : check list;
  formulas : Formulas.asked;  (** of all plans: {!Scc_property.Plan.searches} *)
  patterns : Property.prop array;  (** what is counted *)
  numbers : Property.num array;  (** of which values are asked *)
}

val find : Scc_successors.Filter.t -> t
(** What an exploration asks beside searches. *)

val steady : t -> int -> bool
(** [steady w p] is true if the predicate with this number does not change while time passes. *)

val pattern : t -> Property.prop -> int
(** The place of something that is counted. *)

val number : t -> Property.num -> int
(** The place of a number. *)
