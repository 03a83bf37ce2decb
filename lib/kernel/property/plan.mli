(** What to do for a formula: searches that end at the first run that decides them, where that is all it takes. *)

open Scc_exact

(** Bounds are of model time; [None] is no bound. *)
type t =
  | Now of Property.prop  (** in the initial state *)
  | Possibly of Rat.t option * Property.prop  (** EF *)
  | Always of Rat.t option * Property.prop  (** AG *)
  | Formula of Property.temporal  (** to be evaluated on the graph *)
  | All of t list
  | Any of t list

val of_formula : Property.temporal -> t

val is_search : t -> bool
(** Nothing in it is to be evaluated on the graph. *)

val searches : t -> Property.temporal list
(** The searches that a plan is made of, each as a formula of its own, and what is to be evaluated. *)

val horizon : Property.temporal -> Rat.t option
(** What happens later than this does not matter; [None]: everything may. *)

val latest_horizon : Property.temporal list -> Rat.t option
(** Of several formulas together; 0 of none. *)
