(** Work in a process of its own, which can be ended at any time. *)

(** A process that works. *)
type t

val start : work:((string -> unit) -> 'a) -> progress:(string -> unit) -> ended:('a option -> unit) -> t option
(** [start ~work ~progress ~ended] forks a process that calls [work]. What it passes to its argument is passed to
    [progress] in this process. [ended] gets its result, or [None] if the process came to an end without one. Both
    are called by {!heard}. [Marshal] must accept results. The result is [None] if the system refuses a process. *)

val source : t -> Unix.file_descr
(** The descriptor that becomes readable when there is something for {!heard}. *)

val heard : t -> bool
(** Reads what the process has sent. It is true once the process has ended. *)

val kill : t -> unit
(** Ends the process. [ended] is not called. *)
