(** Cosines and sines of angles, as rationals near them. *)

val pi : Rat.t
(** Pi, rounded to 50 decimals. *)

val cos_sin : Rat.t -> Rat.t * Rat.t
(** [cos_sin d] are the cosine and the sine of [d] degrees, each within 2{^-50}, and exact for multiples of 90
    degrees. *)

val cos_sin_to : bits:int -> Rat.t -> Rat.t * Rat.t
(** [cos_sin_to ~bits d] are the cosine and the sine of [d] degrees, each within 2{^-bits}, and exact for
    multiples of 90 degrees. *)

val cos_sin_radians : Rat.t -> Rat.t * Rat.t
(** [cos_sin_radians x] are the cosine and the sine of [x] radians, each within 2{^-49}, for |x| at most 10{^9}. *)
