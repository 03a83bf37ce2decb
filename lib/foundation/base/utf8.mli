(** UTF-8, as far as readers and reports need it. *)

val length : string -> int -> int
(** [length s i] is the number of bytes, 1 to 4, of the well-formed sequence that begins at byte [i]; 0 if there is
    none. [i] is an index of [s]. *)

type fault =
  | Invalid of int  (** offset of the first byte that is not part of well-formed UTF-8 *)
  | Control of { at : int; size : int; code : int }
  (** the first control character that no text has (NUL, say): its offset, its bytes and its code point *)

val check : string -> fault option
(** [check s] is the first fault of a text. Tab, line feed, form feed and carriage return are allowed. Other
    control characters are not: those below U+0020, and those from U+007F to U+009F. Overlong forms, surrogates and
    code points past U+10FFFF are invalid. *)

val code_point : string -> int
(** [code_point s] is the first code point of the well-formed, non-empty [s]. *)

val boundary : string -> int -> int
(** [boundary s i] is the greatest offset, at most [i], at which no code point of the well-formed [s] is cut. *)
