(** The lexer: words, marks and spaces of a text that {!Scc_base.Utf8.check} accepts, one lexeme at a time. *)

open Scc_base

type lexeme =
  | Token of Parser.token
  | Newline
  | Line_comment
  | Block_comment
  | Fault of fault

(** Text that does not belong to the language. *)
and fault = {
  code : Code.t;
  message : string;
  hint : string option;
  opening : bool;  (** only the first two bytes are at fault (a comment without its end) *)
  instead : Parser.token option;  (** the token that replaces the text, so that reading goes on *)
}

val next : Lexing.lexbuf -> lexeme
(** Reads the next lexeme, whose place is [lexeme_start] to [lexeme_end]. A string and a comment are one lexeme
    each, and block comments nest. After the end of the text every call gives [Token EOF]. *)

val words : (string * Parser.token) list
(** The words of the language with their tokens, in the order of their bytes. Most of them cannot be names;
    {!Tokens.can_be_name} lists the exceptions. *)
