(** Operations on the terms of {!Property}: equality, duality, and what they depend on. *)

open Property

val equal_event : event -> event -> bool
(** [equal_event a b] is true if [a] and [b] have equal rows in the table {!Atom}. *)

val equal_num : num -> num -> bool
(** [equal_num a b] is true if [a] and [b] are the same term. *)

val equal_prop : prop -> prop -> bool
(** [equal_prop a b] is true if [a] and [b] are the same term. *)

val equal : temporal -> temporal -> bool
(** [equal a b] is true if [a] and [b] are the same term. *)

val negate : prop -> prop
(** The complement of a predicate, with [not] only in front of facts. A comparison becomes the complementary one.
*)

val negation_normal_form : temporal -> temporal
(** An equivalent formula in which [Temporal_not] stands only before [Until]: EF and AG, AF and EG, EX and AX
    are duals. *)

val quantifies : path_quantifier -> temporal -> bool
(** [quantifies kind f] is true if a quantifier of this kind is left when negations are driven inward. A
    probability counts as both kinds. Without [Exists], a formula that holds still holds over fewer runs. Without
    [All], a formula that fails still fails over fewer runs (rule CtlLaws). *)

val by_one_run : holds:bool -> temporal -> bool
(** [by_one_run ~holds f] is true if one run may show that [f] holds, or with [~holds:false] that it fails. The
    outermost operators decide. No single run shows a probability. *)

val always : bound
(** The bound of an operator without one: all time from 0 on. *)

val asks_probability : temporal -> bool
(** [asks_probability f] is true if an operator of [f] has a probability for a quantifier. *)

val mentions_time : temporal -> bool
(** [mentions_time f] is true if the atom [time] occurs in [f]. The bounds of operators are relative and do not
    count. *)

val mentions_position : temporal -> bool
(** [mentions_position f] is true if an absolute coordinate or an angular momentum occurs in [f]. A translation may
    then change the value of [f]. *)

val has_events : temporal -> bool
(** [has_events f] is true if an atom [event] occurs in [f]. The value of [f] then depends on the transitions
    that led to a state, too. *)

val events : temporal -> event list
(** The events that occur in a formula, each once, in order. *)

val leaves : temporal -> int list
(** The indices of the leaves that occur in a formula, sorted, each once. *)

val leaves_of_events : temporal -> int list
(** The indices of the leaves that occur in the events of a formula, in order, with repetitions. *)

val global : temporal -> bool
(** [global f] is true if an atom of [f] depends on the whole network ({!Atom.Whole}). Such atoms are bonds or
    events without leaves, the number of processes, energy, momentum, angular momentum and [quiescent]. The atom
    [time] is none, as it depends on no process. *)

val atoms : temporal -> Atom.t list
(** The atoms of a formula in order, with repetitions. *)

val steady : rigid:bool -> prop -> bool
(** [steady ~rigid p] is true if all atoms of [p] keep their values while time passes and nothing happens
    ({!Atom.steady}). *)

val predicates : temporal -> prop list
(** The maximal state predicates of a formula, in order, with repetitions. *)

val state_formula : temporal -> prop option
(** A formula without temporal operators, as one predicate; [None] if it has a temporal operator. *)
