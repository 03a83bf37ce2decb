(** Invariants for people. *)

val to_string : Scc_calculus.Model.t -> Scc_symbolic.Invariant.t -> string
(** Each kind of states with its processes and with what holds of its numbers. Numbers that never change, as the
    place of a fixed body, are left out. *)
