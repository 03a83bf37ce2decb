(** The processes in some slots of a tuple, of a network in translation, with all that follows from them as long
    as none collides. It depends on these slots alone. *)

open Scc_exact

type t

val of_present : Local.alone array -> t
(** The section with these processes, in the order of their slots. *)

val nobody : t
(** The section without slots. *)

val present : t -> Local.alone array
(** All processes of the section, in the order of their slots. *)

val urgent : t -> Local.move list
(** What single processes of the section must do now, the last first. *)

val weak : t -> Local.move list
(** What single processes of the section may do now, the last first. *)

val wait : t -> Rat.t option
(** The least time after which an eps expires or a split instant comes in one of the processes; [None] if there
    is none. *)

val rest : t -> bool
(** [rest s] is true if the velocities of all processes are zero. *)

val in_relative_motion : t -> t -> bool
(** [in_relative_motion a b] is true if two processes of [a] and [b] together have different velocities. *)

val after : Local.t -> Rat.t -> t -> int array
(** [after local d s] is the slots that have another process after a time [d], each followed by the number of that
    process. *)

(** {1 Remembered} *)

(** A cache of the sections that some slots have had more than once, with up to 4096 entries. *)
type memory

val memory : Local.t -> first:int -> beyond:int -> memory
(** An empty cache for the slots from [first] to [beyond] - 1. *)

val look : memory -> int array -> t
(** The section of a tuple in the slots of the cache. *)
