(** Wishes that the program ends: the signals of Ctrl-C, of [kill], of a terminal that is closed and of a limit of
    the system on processor time ([ulimit -t]), all alike.

    The first one raises {!Interrupted} wherever the program is, unless somebody answers, who then sees to it that
    there is a report of what is known. While the program waits for others it raises in any case. A later one, as
    from somebody who will not wait, ends the program by that signal at once. The state is one for the process, as
    its signals are. *)

exception Interrupted of string
(** Why, in words. Whoever catches it ends its work. *)

val signals : int list
(** SIGINT, SIGTERM, SIGHUP and SIGXCPU, which comes every second and ends nothing when it comes again. *)

val listen : unit -> unit
(** From now on they are heard. SIGHUP is not where it was ignored when the program began ([nohup]). *)

val heard : unit -> bool

val answered : (unit -> unit) -> unit
(** From now on the function is called at the first one, instead of an exception. *)

val break_off : unit -> unit
(** Raises {!Interrupted}, now or once no section is {!Scc_base.Critical} any more. *)

val check : unit -> unit
(** Raises {!Interrupted} if that is still to be done. *)

val at_once : (unit -> 'a) -> 'a
(** Waits for others: whoever answers is not waited for. Raises {!Interrupted}. *)

val expire : string -> unit
(** Raises {!Interrupted} for this reason within {!at_once}, and does nothing elsewhere. *)

val ignored : unit -> unit
(** From now on none is heard: the program ends. *)

val leave_to_parent : unit -> unit
(** In a process that this program has started: what comes to all of a terminal's is the parent's to answer, and
    SIGTERM ends it at once. *)

val fork : (unit -> int) -> int
(** Another process, which leaves signals to this one ({!leave_to_parent}) and does the work. That must not return.
    The number of the process. [Unix.Unix_error]. *)
