(** Elimination of variables from constraints: of variables that an equality gives, by substitution, else by J.
    Fourier and T. Motzkin: each bound from above with each bound from below, strictly if either is strict. *)

val step : int list -> equalities:Constraint.t list -> Constraint.t list -> Constraint.t list
(** [step variables ~equalities inequalities] eliminates one or more of the variables, of which there is at least
    one, and all of which occur, of a system that has a solution: what is left. It takes all that equalities give
    if there are any, else one that leaves fewest constraints. *)
