(** Checks as formulas of probabilistic model checkers (PRISM's property language, which Storm reads, too),
    about the MDP of the graph ({!Mdp}). *)

open Scc_property

val formula :
  occurs:(string -> bool) -> State_predicates.t array -> Property.temporal -> (string, string) result
(** A state formula that holds in the initial state iff the property does, if the graph has states for all
    instants at which a predicate changes. All schedulers are all runs: AF is [P>=1 \[F ..\]], and EF, that
    not all schedulers have less than 1, is [!(P<1 \[F ..\])]. The error says what cannot be said so: bounds
    of time, X (a passing of time is a step of the MDP, too) and events. The predicates are those of
    {!State_predicates.of_checks}; labels that hold nowhere, as [occurs] tells, are written [false]. *)
