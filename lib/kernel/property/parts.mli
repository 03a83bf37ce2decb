(** The parts that a number, a predicate or a formula is put together of, one level deep. *)

open Property

type t = { numbers : num list; predicates : prop list }

val of_num : num -> t
(** [of_num n] is the numbers and the predicates directly within [n], in order. *)

val of_prop : prop -> t
(** [of_prop p] is the numbers and the predicates directly within [p], in order. *)

val of_temporal : temporal -> temporal list
(** [of_temporal f] is the formulas directly within [f]; none if [f] is a state predicate. *)

val map_num : num:(num -> num) -> prop:(prop -> prop) -> num -> num
(** [map_num ~num ~prop n] is [n] with these functions applied to its parts. *)

val map_prop : num:(num -> num) -> prop:(prop -> prop) -> prop -> prop
(** [map_prop ~num ~prop p] is [p] with these functions applied to its parts. *)

val map_temporal : (temporal -> temporal) -> temporal -> temporal
(** [map_temporal change f] is [f] with [change] applied to its parts. A state predicate stays as it is. *)
