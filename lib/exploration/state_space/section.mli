(** Who stands in some slots of a tuple, of a network in translation, and what that comes to as long as nobody
    collides: a function of these slots alone. *)

open Scc_exact

type t

val of_present : Local.alone array -> t
(** Of processes in the order of their slots. *)

val nobody : t
(** Of no slots. *)

val present : t -> Local.alone array
val urgent : t -> Local.move list
(** Of all of them, the last first; so are {!weak}. *)

val weak : t -> Local.move list

val wait : t -> Rat.t option
(** The least time after which one of them has waited to the end, if one waits. *)

val rest : t -> bool
(** Whether all of them do. *)

val in_relative_motion : t -> t -> bool
(** Whether two of the processes of both, or of one, are. *)

val after : Local.t -> Rat.t -> t -> int array
(** The slots that have another process when a time has passed, each followed by that process. *)

(** {1 Remembered} *)

(** What some slots have held more than once, for as long as there is room. *)
type memory

val memory : Local.t -> first:int -> beyond:int -> memory
(** Of the slots from [first] on, before [beyond]. *)

val look : memory -> int array -> t
(** Of a tuple. *)
