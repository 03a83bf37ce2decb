(** UTF-8, as far as readers and reports need it. *)

val length : string -> int -> int
(** The bytes of the well-formed sequence at an offset, or 0. *)

type fault =
  | Invalid of int  (** offset of the first byte that is not part of well-formed UTF-8 *)
  | Control of int  (** offset of the first control character that no text has (NUL, say) *)

val check : string -> fault option
(** The first fault of a text. Tab, line feed, form feed and carriage return are allowed. Overlong forms,
    surrogates and code points past U+10FFFF are invalid. *)

val code_point : string -> int
(** The first code point of a well-formed, non-empty string. *)

val boundary : string -> int -> int
(** The greatest offset, at most the given one, at which no code point of a well-formed text is cut. *)
