(** The framing of messages: a header with [Content-Length], an empty line, and so many bytes. *)

(** What has been read of the input. *)
type t

val make : most:int -> t
(** Nothing yet. A message of more than [most] bytes is skipped. *)

val feed : t -> bytes -> int -> unit
(** [feed t bytes n] adds the first [n] bytes of a piece of the input. *)

(** A piece of the input. *)
type piece =
  | Message of string
  | Fault of string  (** a header or a length that cannot be read; reading goes on behind it *)
  | More  (** more input is needed *)

val next : t -> piece
(** The next piece of what was fed. *)

val framed : string -> string
(** The text of a message with its header. *)
