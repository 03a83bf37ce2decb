(** How much work a comparison may do. *)

type t

exception Exhausted
(** Raised by {!spend} and caught by {!Compare.run}. *)

val unlimited : unit -> t

val make : stop:(unit -> bool) -> t
(** [stop] is asked now and then; once it says yes, {!spend} raises. *)

val spend : t -> int -> unit
(** So many small steps were made. *)
