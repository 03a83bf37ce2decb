(** The floats next to a float, as {!Stdlib.Float.succ} and [pred] tell them, without a call into C: filters round
    outward by them in each step. *)

val succ : float -> float
(** The least float that is greater; the same of infinity and of what is no number. *)

val pred : float -> float
(** The greatest float that is less; the same of minus infinity and of what is no number. *)

val sum_below : float -> float -> float
(** The sum, if it is a float, or else one of the two floats next to it: that below it, unless it is infinite. *)

val sum_above : float -> float -> float
(** Likewise that above it. *)
