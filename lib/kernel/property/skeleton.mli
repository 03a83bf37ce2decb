(** The skeleton of properties: timed CTL over numbers instead of state predicates. *)

val of_temporal : Property.temporal list -> Scc_ctl.Timed_formula.t list * Property.prop array
(** The formulas over numbers, and the state predicates that the numbers stand for. Equal predicates have one
    number. *)

val to_temporal : (int -> Property.prop) -> Scc_ctl.Timed_formula.t -> Property.temporal
(** [to_temporal prop f] is [f] with each number [k] replaced by the predicate [prop k]. *)
