(** A cache that says which labels take time, and how many transitions they stand for. Both are computed once for
    each label. *)

type t

val create : duration:(int -> Scc_exact.Rat.t) -> transitions:(int -> int) -> t
(** [create ~duration ~transitions] is an empty cache. [duration label] is the model time that a label takes, and
    [transitions label] the number of transitions that it stands for. *)

val takes_time : t -> int -> bool
(** [takes_time t label] is true if the duration of the label is positive. *)

val transitions : t -> int -> int
(** [transitions t label] is the number of transitions that the label stands for. *)
