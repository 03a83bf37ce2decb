(** The limit [--memory] of commands that make runs in several processes: each has an equal part of it, and the
    command itself all of it. A run ends when its process has taken its part, as at an interruption. *)

type t

val start : ?seconds:float -> memory:int option -> jobs:int -> unit -> t
(** Starts the watch of the command. [memory] is in words (default: that of {!Check_options.words_of}). *)

val watch : t -> Watch.t
(** The watch of the command. *)

val over : t -> bool
(** In a process that makes runs: whether it is to end the run that it makes. *)

val ended : t -> unit
(** Tells the command that a run was ended by a limit. *)

val stopped : t -> bool
(** In the command: whether no more runs are to be made. *)

val reason : t -> string
(** Why no more runs were made, in words. *)
