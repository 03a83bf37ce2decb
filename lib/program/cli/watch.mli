(** Keeps work within its limits of time and memory, and stops it on an interruption
    ({!Scc_system.Interruption}).

    While a watch is active, a timer compares the limits some hundred times a second. Work that calls {!stop}
    ends by itself. Other work is an {!attempt}, and is ended by an exception wherever it is.

    Until the first attempt, or {!has_read}, a command reads its input. If that takes more than the memory, the
    work is broken off by {!Scc_system.Interruption.Interrupted}.

    The conclusions of an exploration have a second more, and the part of the memory that explorations leave. So
    there is always a report. *)

open Scc_graph_search

(** The limits of some work. *)
type t

val start : ?clock:(unit -> float) -> ?signals:bool -> ?seconds:float -> ?memory:int -> unit -> t
(** Starts a watch. [memory] is the limit in words for the whole program. Without limits only an interruption
    ends the work. Without [signals] (default: true) only limits end it, and signals are left to other handlers.
    [clock] gives seconds (default: the time of day). *)

val has_read : t -> unit
(** Tells that the input was read, for work without an {!attempt}. *)

val more : t -> float -> unit
(** Adds seconds, for further work. *)

val stop : t -> unit -> Limits.stop option
(** The reason why an exploration must end now, if there is one. *)

val reason : Limits.stop -> string
(** The reason in words. *)

val attempt : t -> Limits.attempt
(** How work that does not call {!stop} is ended. *)

val surroundings : t -> progress:(Limits.progress -> unit) -> attempt:Limits.attempt -> Limits.surroundings
(** The surroundings of work within the limits of the watch. [attempt] is {!attempt}, or one around it. *)

val half : t -> unit -> unit -> Limits.stop option
(** The condition {!stop} for work that begins now and may take half of the remaining seconds. *)

val interrupted : t -> unit -> bool
(** [interrupted t ()] is true after an interruption: for work that only signals stop. *)

val finish : ?grace:float -> t -> unit
(** Ends the limits: the rest, such as writing the results, takes as long as it needs. After an interruption,
    before or then, it has [grace] more seconds of the processor (default: 1); after these
    {!Scc_system.Interruption.Interrupted} is raised. *)

val dismiss : t -> unit
(** Ends the watch: the rest has no limits. *)
