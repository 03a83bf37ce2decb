(** Total orders on the terms of {!Property}. They have no meaning, but are the same on every machine. *)

open Property

val num : num -> num -> int
(** A total order on numbers: 0 for equal terms only. *)

val prop : prop -> prop -> int
(** A total order on predicates: 0 for equal terms only. *)

val event : event -> event -> int
(** A total order on events, that of their atoms ({!Atom.compare}). *)

val temporal : temporal -> temporal -> int
(** A total order on formulas: 0 for equal terms only. *)
