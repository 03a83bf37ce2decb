(** Formulas with other leaves or with values of parameters, and a normal form up to order. *)

open Property

val temporal : (int -> int) -> temporal -> temporal
(** [temporal image f] is [f] with the index of each leaf replaced by its image. *)

val num : (int -> int) -> num -> num
(** [num image n] is [n] with the index of each leaf replaced by its image. *)

val prop : (int -> int) -> prop -> prop
(** [prop image p] is [p] with the index of each leaf replaced by its image. *)

val ordered : temporal -> temporal
(** An equivalent formula in a normal form, which is equal for formulas that differ only in:
    - the order or the brackets of what [and], [or], [count], [+] and [*] join;
    - the order of the two leaves of a symmetric atom;
    - the direction of a comparison. *)

val ordered_num : num -> num
(** The normal form of a number, as for {!ordered}. *)

val ordered_prop : prop -> prop
(** The normal form of a predicate, as for {!ordered}. *)

val summands : num -> num list
(** The numbers that [+] joins in a sum, whatever its brackets; a number that is no sum by itself. *)

val factors : num -> num list
(** The numbers that [*] joins in a product, whatever its brackets; a number that is no product by itself. *)

val known : Scc_exact.Rat.t array -> Property.prop -> Property.prop
(** [known values p] is [p] with each parameter that has a range replaced by its value, by index into
    {!Scc_calculus.Model.ranges}. *)

val known_temporal : Scc_exact.Rat.t array -> temporal -> temporal
(** [known_temporal values f] is [f] with {!known} applied to all its predicates. *)
