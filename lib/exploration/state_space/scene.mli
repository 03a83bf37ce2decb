(** The places of many processes, in the last state that was given: which are near each other, and which collide.
    States that follow each other differ little as a rule, and only the differences are computed. *)

type t

val create : Local.t -> t
(** A scene without a state. *)

val look : t -> int array -> unit
(** [look t tuple] makes [tuple], of the catalogue, the state of the scene. All functions below are about this
    state. *)

val present : t -> Local.alone array
(** All processes, in the order of their first leaves. *)

val urgent : t -> Local.move list
(** What single processes must do now, the last first. *)

val weak : t -> Local.move list
(** What single processes may do now, the last first. *)

val collisions : t -> Local.move list
(** The outcomes of all collisions now, the last first. *)

val in_relative_motion : t -> bool
(** [in_relative_motion t] is true if two processes have different velocities. *)
