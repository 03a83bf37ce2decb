(** UTF-8, as far as readers and reports need it. *)

val length : string -> int -> int
(** The bytes of the well-formed sequence at an offset, or 0. *)

type fault =
  | Invalid of int  (** offset of the first byte that is not part of well-formed UTF-8 *)
  | Control of int  (** offset of the first control character that no text has (NUL, say) *)

val check : string -> fault option
(** [check s] is the first fault of a text. Tab, line feed, form feed and carriage return are allowed; other
    control characters and DEL are not. Overlong forms, surrogates and code points past U+10FFFF are invalid. *)

val code_point : string -> int
(** [code_point s] is the first code point of the well-formed, non-empty [s]. *)

val boundary : string -> int -> int
(** [boundary s i] is the greatest offset, at most [i], at which no code point of the well-formed [s] is cut. *)
