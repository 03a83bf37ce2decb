(** A cache that says which labels take time. The duration of each label is computed once. *)

type t

val create : duration:(int -> Scc_exact.Rat.t) -> t
(** [create ~duration] is an empty cache; [duration label] is the model time that a label takes. *)

val takes_time : t -> int -> bool
(** [takes_time t label] is true if the duration of the label is positive. *)
