(** Operations on the terms of {!Property}: equality, duality, and what they look at. *)

open Property

val equal_event : event -> event -> bool
val equal_num : num -> num -> bool
val equal_prop : prop -> prop -> bool
val equal : temporal -> temporal -> bool

val equal_modulo_order : temporal -> temporal -> bool
(** Equal but for the order and the brackets of what [and], [or], [count], [+] and [*] join, the order of the
    leaves of symmetric atoms ([bound], [same], [touching], [distance2], [bonds], [event]), and the direction
    of comparisons. Formulas for which it is true are equivalent; the converse is not claimed. *)

val permuted : (int -> int) -> temporal -> temporal
(** The formula with each leaf replaced by its image. *)

val negate : prop -> prop
(** The complement, with [not] pushed to the atoms that have no complement of their own (comparisons have
    one). *)

val negation_normal_form : temporal -> temporal
(** An equivalent formula in which [Temporal_not] stands only before [Until]: EF and AG, AF and EG, EX and AX
    are duals. *)

val quantifies : path_quantifier -> temporal -> bool
(** Whether a quantifier of this kind is left when negations are driven inward. Without any over some run, what
    holds also holds of fewer runs; without any over all runs, what does not hold does not hold of fewer either
    (rule CtlLaws). *)

val by_one_run : holds:bool -> temporal -> bool
(** Whether its outermost operators are such that one run may show that it holds, or that it does not. *)

val always : bound
(** All time. *)

val asks_probability : temporal -> bool
(** Whether some operator has a probability for a quantifier. *)

val mentions_time : temporal -> bool
(** Whether the atom [time] occurs (the bounds of operators are relative and do not count). *)

val mentions_position : temporal -> bool
(** Whether an absolute coordinate occurs: the formula is then not invariant under translation. *)

val mentions_next : temporal -> bool
(** Whether the operator X occurs, so that how many transitions are made matters. *)

val has_events : temporal -> bool
(** Whether an atom [event] occurs: the formula is then about the transitions that led to a state, too. *)

val events : temporal -> event list
(** Those that occur, each once. *)

val leaves : temporal -> int list
(** The leaves that it names, in order, each once. *)

val leaves_of_events : temporal -> int list
(** Those that its events name. *)

val global : temporal -> bool
(** Whether it has an atom that depends on the whole network ({!Atom.Whole}): bonds or events without leaves, the
    number of processes, energy, momentum, [quiescent]. ([time] depends on no process.) *)

val atoms : temporal -> Atom.t list
(** All that occur, in order, each as often as it does. *)

val steady : rigid:bool -> prop -> bool
(** Whether it has no atom whose value may change while time passes and nothing happens ({!Atom.steady}). *)

val predicates : temporal -> prop list
(** The predicates that temporal operators are about, in order. *)

val state_formula : temporal -> prop option
(** The predicate, when no temporal operator occurs. *)
