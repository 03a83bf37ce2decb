(** Values that are computed when they are first needed, and kept.

    Unlike with [lazy], an exception of the computation is not kept: a computation that was given up for its time
    or memory can be tried again. *)

type 'a t

val make : (unit -> 'a) -> 'a t
(** [make f] is the value of [f ()], which is not computed yet. *)

val force : 'a t -> 'a
(** [force v] is the value, computed by the first call that succeeds. An exception of the computation passes
    through, and the next call computes again. *)

val is_known : 'a t -> bool
(** [is_known v] is true once the value has been computed. *)
