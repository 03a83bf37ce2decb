(** Where many processes are, as in the last state that was looked at: who is near whom, and who collides. States
    that are looked at one after another differ little as a rule, and only what differs is worked out. *)

type t

val create : Local.t -> t

val look : t -> int array -> unit
(** At a state, given as a tuple of the catalogue; all below is about it. *)

val present : t -> Local.alone array
(** All processes, in order. *)

val urgent : t -> Local.move list
(** What single processes must do now, the last first. *)

val weak : t -> Local.move list
val collisions : t -> Local.move list

val in_relative_motion : t -> bool
(** Whether two move relative to each other. *)
