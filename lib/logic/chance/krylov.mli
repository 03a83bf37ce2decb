(** Guesses for large components without choices, by a Krylov method (van der Vorst, "Bi-CGSTAB", 1992). It takes
    some tens of products with the matrix where sweeps take thousands. Nothing that is proved depends on it. *)

val approach : Enclosure.t -> Rounded.t -> Enclosure.part -> unit
(** [approach t r part] brings the guesses of [r] in [part] to the solution, nearly. It leaves them as they are in
    a component of fewer than 5000 nodes, in one with choices, and where the method does not converge. *)
