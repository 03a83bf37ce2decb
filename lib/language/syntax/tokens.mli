(** A whole text as an array of tokens. Three facts come with it that the grammar alone cannot find: which brackets
    match, how deep the text nests, and where reading can start again after an error. *)

open Scc_base

type token = {
  token : Parser.token;
  start : int;  (** offset of the first byte *)
  stop : int;  (** offset after the last byte *)
  after_fault : bool;  (** text that is not of the language stands between this token and the one before *)
}

type t = {
  file : string;
  tokens : token array;  (** the last, and only the last, is [EOF] *)
  trivia : Trivia.t list;  (** in the order of the text *)
  faults : Diag.t list;  (** in the order of the text, at most {!max_faults} *)
  opening : int array;  (** for a closing bracket the index of its opening one; [-1] elsewhere *)
  unclosed : bool array;  (** an opening bracket without its closing one *)
  restart : bool array;  (** a declaration begins here, at the top level or in the body of a [for] *)
}

val max_faults : int
(** The number of faults at which reading stops: 20. *)

val max_nesting : int
(** The greatest depth of nested brackets: 1 000. *)

val max_depth : int
(** The greatest depth of a syntax tree: 10 000. At each level of brackets it counts the operators, prefixes and
    summands of one declaration. To these it adds the depth of the deepest bracket among them. *)

val can_be_name : Parser.token -> bool
(** [can_be_name t] is true for a name and for the words that can be names as well. Some of these can be names
    only where no operator can stand. *)

val is_word : string -> bool
(** [is_word text] is true for the words of the language, even for those that can be names as well. *)

val read : ?rewrite:(token array -> token array * Diag.t list) -> Source.t -> t
(** Reads a text into tokens; it never fails. Text that does not belong to the language is left out of [tokens]
    and reported in [faults] (SC0102, SC0104 to SC0107, SC0111). After SC0102 or SC0111 the text must not be
    parsed: see {!hopeless}.

    [rewrite] (default: none) translates the tokens of another notation into those of this grammar, before
    brackets are matched. Its second result is faults. *)

val not_text : string -> Utf8.fault -> Diag.t
(** [not_text file fault] is the error (SC0102) for a file of this name with this fault. *)

val hopeless : t -> bool
(** [hopeless t] is true if the text must not be parsed: it is no text (SC0102), or so deeply nested that a
    later pass could exhaust the stack (SC0111). *)

val span : t -> int -> Span.t
(** [span t i] is the place of the token with the index [i]. *)
