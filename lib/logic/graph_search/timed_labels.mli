(** Which labels take time: most do not, and it is looked up once for each. *)

type t

val create : duration:(int -> Scc_exact.Rat.t) -> t
(** [duration] tells how long a label takes. *)

val takes_time : t -> int -> bool
