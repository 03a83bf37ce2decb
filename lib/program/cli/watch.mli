(** Keeps work within its limits of time and memory, and stops it when somebody asks for that
    ({!Scc_system.Interruption}).

    While a watch is kept, a timer looks some hundred times in a second. Work that asks {!stop} ends by
    itself; work that does not is an {!attempt}, and is given up by an exception wherever it is. What
    concludes what was explored has a second more, and the part of the memory that explorations leave, so
    that there is always a report. *)

open Scc_graph_search

type t

val start : ?clock:(unit -> float) -> ?signals:bool -> ?seconds:float -> ?memory:int -> unit -> t
(** [memory] in words, of all that the program takes. Without limits only an interruption ends the work. Without
    [signals] only limits end the work: signals are somebody else's to answer. [clock] tells seconds, those of the
    day if nothing is said. *)

val more : t -> float -> unit
(** So many seconds more, for another work. *)

val stop : t -> unit -> Limits.stop option
(** What ends an exploration now. *)

val reason : Limits.stop -> string
(** In words. *)

val attempt : t -> Limits.attempt

val surroundings : t -> progress:(Limits.progress -> unit) -> attempt:Limits.attempt -> Limits.surroundings
(** Of work that it keeps within its limits, by [attempt], which makes those of the watch. *)

val half : t -> unit -> unit -> Limits.stop option
(** What ends work that is begun now and may take half of the seconds that are left, if it asks. *)

val interrupted : t -> unit -> bool
(** For work that is stopped by signals alone. *)

val finish : ?grace:float -> t -> unit
(** The work has stopped: what is left to do, such as writing what is known, takes as long as it takes. After an
    interruption, before or meanwhile, it has so many more seconds of the processor, 1 if nothing is said; then
    {!Scc_system.Interruption.Interrupted} is raised. *)

val dismiss : t -> unit
(** The work has stopped, and what follows is not the watch's. *)
