(** One lexeme at a time: the words, marks and spaces of a text that {!Utf8.check} has found well-formed. *)

open Scc_base

type lexeme =
  | Token of Parser.token
  | Newline
  | Line_comment
  | Block_comment
  | Fault of fault

(** Text that is not of the language. *)
and fault = {
  code : Code.t;
  message : string;
  hint : string option;
  opening : bool;  (** only the two first bytes are at fault (a comment without its end) *)
  instead : Parser.token option;  (** what to read on with *)
}

val next : Lexing.lexbuf -> lexeme
(** Its place is [lexeme_start] to [lexeme_end]; a string and a comment are one lexeme each. Block comments
    nest. After the end of the text it is [Token EOF] for ever. *)

val words : (string * Parser.token) list
(** The words of the language, in alphabetical order; no name may be one of them, but for [bond] and
    [mass]. *)
