(** The skeleton of properties: timed CTL over numbers instead of state predicates. *)

val of_temporal : Property.temporal list -> Scc_ctl.Formula.t list * Property.prop array
(** The same formulas over the state predicates that occur in them, equal ones shared. *)

val to_temporal : (int -> Property.prop) -> Scc_ctl.Formula.t -> Property.temporal
(** Back, with the predicates as given. *)
