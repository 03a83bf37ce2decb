(** From a formula to the questions that decide it. *)

open Scc_exact
open Scc_property

(** A state predicate under one operator. Bounds are of model time; [None] is no bound. *)
type t =
  | Now of Property.prop  (** in the initial state *)
  | Possibly of Rat.t option * Property.prop  (** EF *)
  | Always of Rat.t option * Property.prop  (** AG *)
  | Eventually of Rat.t option * Property.prop  (** AF *)
  | Not_eventually of Rat.t option * Property.prop
  | All of t list
  | Any of t list

val of_formula : Property.temporal -> (t, string) result
(** Connectives over EF, AG and AF of state predicates, with [within] or [<= b] or without a bound. The
    rest is not executed by this version: the error says what it is. *)
