(** From text to syntax tree. The language is told in [specs/language.md].

    Errors are results, several at a time: after one, reading starts again at the next declaration. They are
    sorted, at most {!max_errors}, and the same from run to run. Codes: SC0102 (not text), SC0104 and SC0105
    (lexical), SC0106 (a number too large), SC0107 (a division by a literal zero), SC0110 (syntax), SC0111
    (nested too deeply, see {!Tokens.max_nesting} and {!Tokens.max_depth}) and SC0112 (nothing declared).

    No exception, and no recursion on what is read: the stack is bounded whatever the text. The tree is no
    deeper than {!Tokens.max_depth} allows, so that a plain recursion over it is safe. *)

open Scc_base
open Scc_exact

val max_errors : int
(** 20. *)

val parse : Source.t -> (Ast.model, Diag.t list) result
(** A whole model. *)

val with_trivia : ?tokens:(Source.t -> Tokens.t) -> Source.t -> (Ast.model * Trivia.t list, Diag.t list) result
(** The same with the comments and empty lines, for {!Printer.model}. [tokens] reads a text of another notation
    into tokens of this grammar, each at its place in that text. *)

val readable : ?tokens:(Source.t -> Tokens.t) -> Source.t -> Ast.model
(** What can be read of a text that may be full of faults: the declarations that are whole, each by itself where
    the text as such is refused. Nothing, if it is no text at all. *)

val expression : Source.t -> (Ast.expr, Diag.t list) result
(** A number or formula alone, the whole text. *)

val model_of : Tokens.t -> Source.t -> (Ast.model, Diag.t list) result
(** The same of tokens, wherever they come from: their places are of that source. *)

val expression_of : Tokens.t -> Source.t -> (Ast.expr, Diag.t list) result

val rational : Source.t -> (Rat.t, Diag.t list) result
(** A number given on the command line: ["6"], ["-1/4"], ["0.125"], ["1e-3"]. *)
