(** Bytes of addresses that are written as a percent sign and two hexadecimal digits, as in RFC 3986, section 2.1.
*)

val decoded : string -> string
(** [decoded text] is [text] with each such triple replaced by its byte: ["%7B"] is ["{"]. A percent sign that
    begins no triple stays. *)

val decoded_strictly : string -> string option
(** [decoded_strictly text] is [Some (decoded text)], and [None] if a percent sign of [text] begins no triple. *)
