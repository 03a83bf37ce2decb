(** Sums over the slots of tuples. Each tuple is compared with the one before, and only the slots that differ are
    added. *)

open Scc_exact

val rationals : width:int -> (int -> (Rat.t, 'why) result) -> int array -> (Rat.t, 'why) result
(** [rationals ~width value tuple] is the sum of the values of the first [width] slots of [tuple], or the error
    of the first slot without a value. [value] takes the number in a slot. Applied to [width] and [value] alone,
    it makes the memory of the last tuple. An exception of [value] leaves that memory valid. *)

val integers : width:int -> (int -> int) -> int array -> int
(** [integers ~width value tuple] is the sum of the values of the first [width] slots of [tuple], as integers,
    with a memory as in {!rationals}. *)
