(** The floats next to a float, as those of [Stdlib.Float.succ] and [pred], but without a call into C. Float
    filters round outward with them in each step. *)

val succ : float -> float
(** [succ x] is the least float greater than [x]; infinity and NaN are returned unchanged. *)

val pred : float -> float
(** [pred x] is the greatest float less than [x]; minus infinity and NaN are returned unchanged. *)

val sum_below : float -> float -> float
(** [sum_below a b] is a + b if that is a float, and otherwise the greatest float below it. If the
    rounded sum is infinite, it is {!pred} of that. *)

val sum_above : float -> float -> float
(** [sum_above a b] is a + b if that is a float, and otherwise the least float above it. If the
    rounded sum is infinite, it is {!succ} of that. *)
