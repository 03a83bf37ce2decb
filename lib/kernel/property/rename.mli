(** Formulas with other leaves or with values of parameters, and a normal form up to order. *)

open Property

val temporal : (int -> int) -> temporal -> temporal
(** [temporal image f] is [f] with the index of each leaf replaced by its image. *)

val check : (int -> int) -> check -> check
(** [check image c] is [c] with the index of each leaf replaced by its image, in its formula and in its mean. *)

val ordered : temporal -> temporal
(** An equivalent formula in a normal form, which is equal for formulas that differ only in:
    - the order or the brackets of what [and], [or], [count], [+] and [*] join;
    - the order of the two leaves of a symmetric atom;
    - the direction of a comparison. *)

val known : Scc_exact.Rat.t array -> Property.prop -> Property.prop
(** [known values p] is [p] with each parameter that has a range replaced by its value, by index into
    {!Scc_calculus.Model.ranges}. *)

val known_temporal : Scc_exact.Rat.t array -> temporal -> temporal
(** [known_temporal values f] is [f] with {!known} applied to all its predicates. *)
