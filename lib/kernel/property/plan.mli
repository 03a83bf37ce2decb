(** How to evaluate a formula: by searches that end at the first run that decides them, where such searches are
    enough; else on the graph. *)

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
(** A plan that is equivalent to the formula. EF and AG of state predicates, with bounds from 0, become searches,
    also under negation. *)

val is_search : t -> bool
(** [is_search plan] is true if nothing in [plan] is to be evaluated on the graph. *)

val searches : t -> Property.temporal list
(** The elements of a plan in order, each as a formula of its own: its searches, and what is to be evaluated on the
    graph. *)

type reach = { time : Rat.t; events : int }
(** The positions of runs up to a model time, and those that follow by at most so many events after that time. *)

val reach : Property.temporal -> reach option
(** [reach f] is the positions that the truth of [f] in the initial state depends on, where [time] is counted from
    that state; [None] if there is no such bound. *)

val latest : reach option list -> reach option
(** The union of what several formulas depend on: of time 0 and no events for the empty list, [None] if one of them
    has no bound. *)

val latest_horizon : Property.temporal list -> Rat.t option
(** A model time from the initial state after which nothing changes the values of the formulas: 0 for the empty
    list, [None] if there is no such time, as with X, whose next event may be however late. *)
