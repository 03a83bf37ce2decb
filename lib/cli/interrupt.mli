(** Interruption: from the keyboard, by a request to end (SIGINT, SIGTERM), or by the clock. *)

val grace : float
(** Seconds that the program has to stop cleanly. *)

val install : unit -> unit -> bool
(** [install ()] catches the signals from now on; the function that it returns tells whether one has
    arrived, so that the work can stop and report, for which it may take its time. Work that does not ask in
    time (see {!grace}) is given up: a message, and exit code 4. The second signal ends the program at once. *)

val in_time : unit -> unit
(** The work has stopped in time: what is left to do, such as writing what is known, takes as long as it takes.
    Another signal ends the program at once. *)

val attempt : Scc_explore.Limits.attempt
(** Does something that does not ask whether it is to stop: once the time is over, or a signal has arrived, it has
    the {!grace} to end, and is given up otherwise. What it was to find is then not known; all else is. *)

val deadline : float -> unit
(** [deadline s]: unless the program ends before, work is given up after [s] seconds and the {!grace}. *)

val clock : float -> unit -> float
(** [clock s] is {!deadline}[ s] for explorations, and gives a clock in seconds: work that has read off it that the
    [s] seconds are over is not given up, as it is about to stop; nor is what comes after an exploration. *)

val ended : unit -> unit
(** An exploration is over. When the clock is read the next time, another one is under way. *)
