(** Invariants as text. *)

val to_string : Scc_calculus.Model.t -> Scc_certificate.Invariant.t -> string
(** Each kind of states with its processes and the constraints on its numbers. Numbers that never change, such
    as the position of a fixed body, are left out. *)
