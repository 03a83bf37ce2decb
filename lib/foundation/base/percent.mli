(** Bytes of addresses that are written as a percent sign and two hexadecimal digits, as in RFC 3986, section 2.1. *)

val decoded : string -> string
(** The text with each such triple replaced by its byte: ["%7B"] is ["{"]. A percent sign that begins no triple stays. *)

val decoded_strictly : string -> string option
(** The same; [None] if a percent sign begins no triple. *)
