(** Checks as formulas of probabilistic model checkers (PRISM's property language, which Storm reads, too),
    about the MDP of the graph ({!Mdp}). *)

open Scc_property

val check :
  occurs:(string -> bool) -> draws:bool -> State_predicates.t array -> Property.check -> (string, string) result
(** {!formula}, or for what a check asks ([= ?]) the questions, separated by semicolons: times are those of the
    reward model [time]. *)

val formula :
  occurs:(string -> bool) -> draws:bool -> State_predicates.t array -> Property.temporal -> (string, string) result
(** A state formula that holds in the initial state iff the property does, if the graph has states for all
    instants at which a predicate changes. All schedulers are all runs: AF is [P>=1 \[F ..\]], and EF, that not
    all schedulers have less than 1, is [!(P<1 \[F ..\])]; where velocities are drawn ([draws]), that some
    scheduler has more than 0, [!(P<=0 \[F ..\])]. The error says what cannot be said so: bounds of time, X (a
    passing of time is a step of the MDP, too), events and, with [draws], AF, EG and A\[U\], to which runs
    matter that have probability 0. The predicates are those of {!State_predicates.of_checks}; labels that hold
    nowhere, as [occurs] tells, are written [false]. *)
