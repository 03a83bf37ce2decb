(** Messages between this process and a worker that it forks. *)

type t

val fork : (t -> unit) -> t option
(** [fork work] is a channel to a new process, which runs [work] with the other end. That process exits at the
    end of [work], without the exit actions of this one. Interruptions are left to this process. The result is
    [None] if the system gives no process, or no descriptor that can be waited for. *)

val put : t -> Buffer.t -> unit
(** Sends the contents of the buffer as one message. Raises {!Closed}. *)

val get : t -> string
(** Waits for the next message and returns it. Raises {!Closed}. *)

exception Closed
(** The other process has ended. *)

val ready : ?seconds:float -> t list -> t list
(** The channels that have a message, or whose process has ended. It waits for one at most 0.2 seconds, or
    [seconds] if these are fewer; interruptions may come in between. *)

val close : t -> unit
(** Kills the other process and closes the channel. *)
