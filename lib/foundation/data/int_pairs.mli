(** Hash tables whose keys are pairs of integers. *)

include Hashtbl.S with type key = int * int
