(** The one exception of scc: a fault of the program itself, never of its input. *)

exception Bug of (string * int * int * int) * string
(** [Bug (pos, what)]: the invariant [what] was found broken at [pos]
    (the value of [__POS__]). The command line reports it and exits with 70. *)

val fail : string * int * int * int -> string -> 'a
(** [fail __POS__ what] raises {!module-Bug}. *)

val broken : exn -> string option
(** [broken e] is the text of an exception that shows a fault of the program: [Bug], or one that the language and
    its library raise after a wrong call, such as [Invalid_argument]. It is [None] for all others: limits,
    interruptions, lack of memory. *)
