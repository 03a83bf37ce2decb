(** Exact statistics of the values of one number. *)

open Scc_exact

(** The values so far. *)
type t

val empty : t
(** No values. *)

val add : t -> Rat.t -> t
(** Adds a value. *)

val count : t -> int
(** The number of values. *)

val mean : t -> Rat.t
(** The mean; it needs at least one value. *)

val variance : t -> Rat.t option
(** The variance of the sample: the sum of the squared distances from the mean, divided by the number of values
    less one. [None] for fewer than two values. *)

val least : t -> Rat.t
(** The least value; it needs at least one. *)

val greatest : t -> Rat.t
(** The greatest value; it needs at least one. *)

val sorted : t -> Rat.t array
(** All values, from the least to the greatest. The array must not be changed. *)

val quantile : t -> Rat.t -> Rat.t
(** [quantile t q] is the quantile by nearest rank: the least value such that a share of at least [q] of all
    values is not above it. For [q] = 0 it is the least value. It needs at least one value. *)

val root : decimals:int -> Rat.t -> string
(** The square root of a number that is not negative, rounded to [decimals] decimals, half a unit upwards. *)
