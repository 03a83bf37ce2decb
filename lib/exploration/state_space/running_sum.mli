(** Sums over the slots of tuples that are asked for one after the other: of each tuple that is seen after another,
    only what differs is added. *)

open Scc_exact

val rationals : width:int -> (int -> (Rat.t, 'why) result) -> int array -> (Rat.t, 'why) result
(** [rationals ~width value] sums the values of the first [width] slots of each tuple, which depend on what is in
    them alone; or it is the reason of the first slot that has no value. The value of -1 is zero. It may be given
    up anywhere, by an exception of [value] as well. *)

val integers : width:int -> (int -> int) -> int array -> int
(** The same of integers, which all slots have. *)
