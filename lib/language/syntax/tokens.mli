(** A whole text as an array of tokens, with what the grammar alone cannot see: which brackets match, how
    deep things nest, and where reading can start again after an error. *)

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
(** Reading stops after this many faults: 20. *)

val max_nesting : int
(** Brackets may nest this deep: 1 000. *)

val max_depth : int
(** A syntax tree may be this deep: 10 000. What counts is, at every level of brackets, the operators,
    prefixes and summands of one declaration, plus the deepest thing in brackets among them. *)

val can_be_name : Parser.token -> bool
(** A name, or one of the words that can be names as well, be it only where no operator can stand. *)

val read : ?rewrite:(token array -> token array * Diag.t list) -> Source.t -> t
(** [rewrite] makes tokens of this grammar of those that were read, in another notation's order of words, before
    brackets are matched; what it cannot make sense of is among the faults. Never fails: what is not of the
    language is left out of [tokens] and told in [faults] (codes SC0102, SC0104 to SC0107, SC0111). After SC0102
    or SC0111 the text is not to be parsed: see {!hopeless}. *)

val not_text : string -> string -> Utf8.fault -> Diag.t
(** What is said (SC0102) of a file by this name, with this text. *)

val hopeless : t -> bool
(** The faults are such that parsing makes no sense or could exhaust the stack of a later pass. *)

val span : t -> int -> Span.t
(** The place of the token with this index. *)
