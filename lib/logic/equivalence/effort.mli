(** Limits of the work of a comparison. *)

type t

exception Exhausted
(** Raised by {!spend} and caught by {!Compare.run}. *)

val unlimited : unit -> t
(** [unlimited ()] is an effort that is never exhausted. *)

val make : stop:(unit -> bool) -> t
(** [make ~stop] is an effort that ends once [stop ()] is true. {!spend} calls [stop] every 100 000 steps. *)

val spend : t -> int -> unit
(** [spend t n] counts [n] more small steps. It raises {!Exhausted} if the effort has ended. *)
