(** Diagnostics: what is wrong with an input, where, and what to do about it. *)

type severity = Error | Warning

type t = {
  code : string;  (** stable, listed in {!Code}, e.g. ["SC0201"] *)
  severity : severity;
  span : Span.t;  (** {!Span.none} when no text is at fault *)
  message : string;  (** one sentence, no final full stop *)
  notes : (Span.t * string) list;  (** other places that matter *)
  hint : string option;  (** e.g. ["did you mean `top`?"] *)
}

val error :
  ?notes:(Span.t * string) list ->
  ?hint:string ->
  Code.t ->
  Span.t ->
  ('a, unit, string, t) format4 ->
  'a
(** [error code span fmt ...] is an error with the message [fmt ...]. *)

val warning :
  ?notes:(Span.t * string) list ->
  ?hint:string ->
  Code.t ->
  Span.t ->
  ('a, unit, string, t) format4 ->
  'a
(** [warning code span fmt ...] is a warning with the message [fmt ...]. *)

val of_file : string -> t -> t
(** [of_file file d] is [d], with {!Span.whole} of the file for its place if it has none. *)

val is_error : t -> bool
(** [is_error d] is true for an error, and false for a warning. *)

val compare : t -> t -> int
(** The order by file and start of the span; then errors before warnings, then by code and message. *)

val nearest : string -> string list -> string option
(** [nearest name candidates] is the candidate that {!suggest} suggests. *)

val suggest : string -> string list -> string option
(** [suggest name candidates] is the hint ["did you mean `c`?"] for the candidate nearest to [name]. Its edit
    distance must be that of a likely slip: at most a third of the length of [name], or 1. Of candidates at one
    distance, one that lacks a letter or has one more is nearer than one with another letter. Names of more than
    64 bytes get no hint. *)

val suggestions : string -> string list
(** [suggestions hint] is the names that a hint suggests which begins as one of {!suggest}: ["did you mean `a`?"],
    or ["did you mean `a` or `b`?"]. It is [[]] for any other hint. *)

val render : source:(string -> Source.t option) -> t -> string
(** [render ~source d] is the text of [d] for people, of several lines that each end with a newline. It has the
    place [file:line:column], severity and code, the message, the first line of the span with carets under it,
    notes and hint. Columns count Unicode code points from 1. Characters that change how a terminal shows the rest
    are written out ({!Visible}). [source] finds the text of a file by the name in the span. *)
