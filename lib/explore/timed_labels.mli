(** Which labels take time: most do not, and it is looked up once for each. *)

type t

val create : unit -> t

val takes_time : t -> int -> duration:(int -> Scc_exact.Rat.t) -> bool
(** Of a label, of which [duration] tells how long it takes when it is asked for the first time. *)
