(** The one exception of scc: a fault of the program itself, never of its input. *)

exception Bug of (string * int * int * int) * string
(** [Bug (pos, what)]: the invariant [what] was found broken at [pos]
    (the value of [__POS__]). The command line reports it and exits with 70. *)

val fail : string * int * int * int -> string -> 'a
(** [fail __POS__ what] raises {!Bug}. *)

val broken : exn -> string option
(** What was broken, where the exception tells of a fault of the program: {!Bug}, or what the language and its
    library raise when they are asked for what cannot be. [None] of all others: limits, interruptions, no
    memory. *)
