(** Critical sections: work that an exception of a timer must not interrupt.

    Work that takes too long is given up by an exception that a timer raises at any point of the program. A table
    that is being changed at that point would be left inconsistent, although the program goes on to use it.
    Such a change is made in a critical section, and the timer tries again later. *)

val run : (unit -> 'a) -> 'a
(** [run f] is [f ()], run as a critical section. It ends with [f], also by an exception. [f] has to be short. *)

val active : unit -> bool
(** [active ()] is true while a critical section runs. A handler that would raise tries again later instead. *)

val enter : unit -> unit
(** [enter ()] begins a critical section that raises no exception, where the closure of {!run} costs too much.
    Sections may be nested. *)

val leave : unit -> unit
(** [leave ()] ends the section that the last {!enter} began. *)
