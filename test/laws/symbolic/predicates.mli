(** Random state predicates whose numbers are linear. *)

open Scc_property

val generate : int -> timed:bool -> int -> Property.prop QCheck2.Gen.t
(** Of so many bodies, of that depth; [timed]: time may be asked for. *)
