(** The independence of the check of invariants ([lib/verification/certificate]) from the search for them. *)

val strangers : unit -> string list
(** Libraries that the check uses beside the kernel, polyhedra, and the meaning of predicates. *)

val borrowed : unit -> string list
(** Places where the search ([lib/verification/symbolic]) names more of the check than what an invariant is. *)
