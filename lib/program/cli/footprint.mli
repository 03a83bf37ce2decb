(** What the program takes of the machine, as the system tells; where it does not, what the heap takes. *)

val resident : unit -> float
(** Bytes in memory, but for what files have as well, which the system may drop at any time. *)

(** {1 Addresses}

    Where the system limits them ([ulimit -v], RLIMIT_AS) a program takes more of them than memory, and where none
    are left it may be ended in the midst of arithmetic, or of collecting garbage. So less than all are used: what
    is kept is for steps between two looks. *)

val is_limited : bool

val told : string option
(** For whoever was stopped by it: what the limit is. *)

val at_most : int -> int
(** So many words of memory, or fewer if there are no addresses for them. *)

val taken : unit -> float
(** Of those that may be used, the share that is; 1 leaves enough to end well. 0 where they are not limited. *)
