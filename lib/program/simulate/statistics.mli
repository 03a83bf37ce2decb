(** What many values of one number look like, exactly. *)

open Scc_exact

type t

val empty : t
val add : t -> Rat.t -> t
val count : t -> int

(** All of these of one value or more. *)

val mean : t -> Rat.t

val variance : t -> Rat.t option
(** Of the sample: the sum of squared distances from the mean over one less than there are; of two or more. *)

val least : t -> Rat.t
val greatest : t -> Rat.t

val quantile : t -> Rat.t -> Rat.t
(** By the nearest rank: the least value such that a share of all, at least q, is not above it; for 0 the least. *)

val root : decimals:int -> Rat.t -> string
(** The square root of a number that is not negative, rounded to so many decimals, half a unit upwards. *)
