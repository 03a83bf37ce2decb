(** Values that are worked out when they are first asked for, and kept.

     Unlike with [lazy], an exception on the way is not kept: work that was given up for its time or memory
    can be asked for again. *)

type 'a t

val make : (unit -> 'a) -> 'a t
val force : 'a t -> 'a

val is_known : 'a t -> bool
(** Whether it has been worked out. *)
