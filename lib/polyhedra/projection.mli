(** Elimination of variables from constraints: of variables that an equality gives, by substitution, else by J.
    Fourier and T. Motzkin: each bound from above with each bound from below, strictly if either is strict. *)

val step :
  int list -> equalities:Constraint.t list -> Constraint.t list -> int * Constraint.t list
(** [step variables ~equalities inequalities] eliminates one of the variables, of which there is at least one, of
    a system that has a solution: which one, and what is left. It takes one that an equality gives if there is
    any, else one that leaves fewest constraints. *)
