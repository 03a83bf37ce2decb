(** Numbers for things that several processes meet, each at its own time: all processes give equal things equal
    numbers. A thing is told by a text, which is the same for equal things in each process. A process looks up a
    text only where it meets something for the first time. *)

type t
(** The texts and their numbers, in memory that processes share which are forked afterwards. *)

val create : first:int -> t option
(** [create ~first] is an empty table, whose numbers begin with [first]; [None] if the system gives no such
    memory. *)

(** The numbers of one kind of things in this process. Its own numbers, by which it finds the things, count from
    0 as they come up; the common ones are those of all processes. *)
type numbers

val numbers : unit -> numbers
(** [numbers ()] is numbers that are shared with nobody: the common numbers are the own ones. *)

val share : numbers -> t -> kind:int -> base:int -> unit
(** [share n t ~kind ~base] shares the numbers from [base] on by a table. Own numbers below [base] are those of
    the things that this process knows already, and that processes know which are forked afterwards; [base] is at
    most the first number of the table. [kind] is at least 0, and differs from that of other numbers in the
    table. *)

val common : numbers -> int -> (int -> string) -> int
(** [common n own name] is the common number of the thing with this own number, if [name own] is its text. *)

val own : numbers -> int -> (string -> int) -> int
(** [own n number make] is the own number of the thing with this common number. If it has none yet, [make text]
    is called, which gives it one. *)

(** {1 Several processes} *)

val refresh : t -> unit
(** [refresh t] is called by a process now and then, and at any rate after another one has called {!make_room}.
*)

val is_room_wanted : t -> bool
(** [is_room_wanted t] is true if {!make_room} should be called soon. *)

val make_room : t -> unit
(** [make_room t] makes room for more. No other process may look up any text meanwhile. It raises {!Limits.Over}
    if there is no more memory. *)

val go_on_apart : t -> full:(unit -> unit) -> unit
(** [go_on_apart t ~full] is called by a process that has been forked, before it looks up any text. [full] is as
    for {!set_full}. *)

val set_full : t -> (unit -> unit) -> unit
(** [set_full t full]: this process calls [full] where a text does not fit. It calls {!make_room}, or raises. *)
