(** What the program takes of the machine, as the system tells; where it does not, what the heap takes. *)

val resident : unit -> float
(** Bytes in memory, but for what files have as well, which the system may drop at any time. *)

(** {1 Limits of the system}

    Where the system limits the addresses of this process ([ulimit -v], RLIMIT_AS) it takes more of them than
    memory; of its data ([ulimit -d], RLIMIT_DATA) about as much. Where nothing is left it may be ended in the
    midst of arithmetic, or of collecting garbage. So less than all is used: what is kept is for steps between
    two looks. *)

val is_limited : bool

val at_most : int -> int
(** So many words of memory, or fewer if the limits leave no room for them. *)

val room_below : int -> int option
(** The limit, in words, that leaves no room for so many: the one that leaves least. *)

val taken : unit -> float
(** Of what may be used, the share that is; 1 leaves enough to end well. 0 where nothing is limited. *)

val small_stack : int option
(** The limit of the system on the stack, in KiB, where it is below the 1 MiB with which everything has to work. *)
