(** Requests to end the program: the signals of Ctrl-C, of [kill], of a terminal that is closed and of a limit of
    the system on processor time ([ulimit -St]). All are treated alike.

    The first request raises {!Interrupted} at any point of the program, unless a handler is installed
    ({!answered}). A handler ensures a report of the results so far. While the program waits for other processes
    ({!at_once}), a request raises in any case. A later request ends the program by its signal at once, if it comes
    more than half a second after the first. The state is global to the process, as signals are. *)

exception Interrupted of string
(** The reason, in words. Code that catches it must end its work. *)

val signals : int list
(** SIGINT, SIGTERM, SIGHUP and SIGXCPU. SIGXCPU comes every second, and its repetitions end nothing. *)

val listen : unit -> unit
(** [listen ()] installs the handlers of {!signals}, once. SIGHUP stays ignored if it was ignored when the program
    began ([nohup]). *)

val heed : unit -> unit
(** [heed ()] lets requests through. The program [scc] holds them from its first instruction on
    ([bin/beginning.c]), until a command can answer them in its own format. It raises {!Interrupted} if one has
    come and no handler is installed. Later calls do nothing. *)

val heard : unit -> bool
(** [heard ()] is true once a request has come. *)

val answered : (unit -> unit) -> unit
(** [answered react] lets the first request call [react] instead of raising an exception. It also calls {!listen}.
*)

val settle : unit -> unit
(** [settle ()] is called when all work is done and a document with the exit code is about to be written. From now
    on the first request changes nothing, so that the exit code of the process is that of the document. If
    {!break_off} was called and its exception has not been raised yet, [settle] raises {!Interrupted}. *)

val break_off : unit -> unit
(** [break_off ()] raises {!Interrupted} now, or after the present critical section ({!Scc_base.Critical}). *)

val check : unit -> unit
(** [check ()] raises {!Interrupted} if {!break_off} was called. *)

val at_once : (unit -> 'a) -> 'a
(** [at_once f] is [f ()], which waits for others. A request before or during it raises {!Interrupted}, even if a
    handler is installed. *)

val expire : string -> unit
(** [expire reason] raises {!Interrupted} for this reason within {!at_once}, outside of critical sections.
    Elsewhere it does nothing. *)

val ignored : unit -> unit
(** [ignored ()] ignores all {!signals} from now on: the program is ending. *)

val fork : ?obedient:bool -> (unit -> int) -> int
(** [fork work] starts a process that leaves the signals of a terminal to this one and runs [work], which must
    not return. The result is the number of the process. [Unix.Unix_error] if the system refuses it.

    An [obedient] process (default: false) also leaves SIGTERM to this one, while this one lives. It is asked to
    end by the signal {!request}: then {!heard} is true there. After 0.2 seconds more, its work within {!at_once}
    is ended by {!Interrupted}. *)

val request : int
(** The signal that asks an obedient process of {!fork} to end: SIGUSR1. *)
