(** Checks as formulas of probabilistic model checkers (PRISM's property language, which Storm reads, too),
    about the MDP of the graph ({!Mdp}). *)

open Scc_property

val check :
  occurs:(string -> bool) -> draws:bool -> State_predicates.t array -> Property.check -> (string, string) result
(** The formula of a check, as by {!formula}. A check that requests numbers ([= ?]) becomes its questions,
    separated by semicolons. Times are those of the reward model [time]. Means of events or of values at a time
    are errors. *)

val formula :
  occurs:(string -> bool) -> draws:bool -> State_predicates.t array -> Property.temporal -> (string, string) result
(** A state formula that holds in the initial state iff the property does, if the graph has states for all
    instants at which a predicate changes. Labels that hold nowhere by [occurs] are written [false]. The
    predicates are those of {!State_predicates.of_checks}.

    All schedulers are all runs: AF is [P>=1 \[F ..\]]. EF says that not all schedulers have less than 1: [!(P<1
    \[F ..\])]. If velocities are drawn ([draws]), it says that some scheduler has more than 0: [!(P<=0
    \[F ..\])].

    The error names what has no formula: bounds of time, X (a passing of time is a step of the MDP, too), and
    events. With [draws] these are also AF, EG and A\[U\], for which runs of probability 0 matter. *)
