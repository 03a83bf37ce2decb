(** Messages to another process and back. *)

type t

val fork : (t -> unit) -> t option
(** Another process, which has the other end, does this with it and ends without what this one would do at its end.
    It does not answer interruptions, which are this one's to answer. None where the system gives no process, or no
    descriptor that can be waited for. *)

val put : t -> Buffer.t -> unit
(** Sends the whole. Raises {!Closed}. *)

val get : t -> string
(** The next message, which is waited for. Raises {!Closed}. *)

exception Closed
(** The other process is no more. *)

val ready : t list -> t list
(** Waits, but not for long, until there is something to get from some of them; interruptions may come in
    between. *)

val has_message : t -> bool
(** There is something to get now. *)

val close : t -> unit
(** Ends the other process. *)
