(** Formulas with other leaves in place of theirs, and one form for those that differ in order alone. *)

open Property

val temporal : (int -> int) -> temporal -> temporal
(** Each leaf replaced by its image. *)

val num : (int -> int) -> num -> num
val prop : (int -> int) -> prop -> prop

val check : (int -> int) -> check -> check
(** The same of all that is asked. *)

val ordered : temporal -> temporal
(** An equivalent formula: two that differ in the order or the brackets of what [and], [or], [count], [+] and
    [*] join, in the order of the two leaves of a symmetric atom, or in the direction of a comparison, have
    one and the same. *)

val ordered_num : num -> num
val ordered_prop : prop -> prop

val summands : num -> num list
(** What [+] joins, whatever the brackets; a number that is no sum by itself. *)

val factors : num -> num list
(** The same of [*]. *)

val known : Scc_exact.Rat.t array -> Property.prop -> Property.prop
(** Where parameters with ranges have these values. *)

val known_temporal : Scc_exact.Rat.t array -> temporal -> temporal
(** The same of whole formulas. *)
