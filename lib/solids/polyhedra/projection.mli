(** Elimination of variables from constraints. A variable of an equality is eliminated by substitution. Other
    variables are eliminated by the method of J. Fourier and T. Motzkin. That method combines each upper bound
    with each lower bound, strictly if either is strict. *)

val step : int list -> equalities:Constraint.t list -> Constraint.t list -> Constraint.t list
(** [step variables ~equalities inequalities] eliminates at least one of the variables from a system that has a
    solution. It returns the constraints that are left. There is at least one variable, and each occurs in the
    system. If equalities mention some of them, these are substituted; otherwise one variable is eliminated
    whose elimination leaves fewest constraints. *)
