(** From text to syntax tree, by the grammar of [specs/language.md].

    Errors are results, several at a time: after an error, reading starts again at the next declaration. They
    are sorted, at most {!max_errors}, and the same from run to run. Codes: SC0102 (not text), SC0104 and SC0105
    (lexical), SC0106 (a number too large) and SC0107 (a division by a literal zero). Others are SC0110 (syntax),
    SC0111 (nested too deeply, see {!Tokens.max_nesting} and {!Tokens.max_depth}) and SC0112 (nothing declared).

    No function raises an exception or recurses on its input, so the stack is bounded for every text. The tree
    is at most as deep as {!Tokens.max_depth} allows, so a plain recursion over it is safe. *)

open Scc_base

val max_errors : int
(** The most errors that one reading returns: 20. *)

val product_hint : string
(** The hint of the error for a product without its sign, such as [2i]. *)

val joined_hint : string -> string option
(** [joined_hint hint] is the word, such as [AF], of which a hint says that its two letters are one word; [None]
    for any other hint. *)

val parse : Source.t -> (Ast.model, Diag.t list) result
(** Reads a whole model. A text without declarations is an error (SC0112). *)

val with_trivia : ?tokens:(Source.t -> Tokens.t) -> Source.t -> (Ast.model * Trivia.t list, Diag.t list) result
(** Reads a whole model together with its comments and empty lines, for {!Printer.model}. [tokens] (default:
    {!Tokens.read}) reads a text of another notation into tokens of this grammar, each at its place in that
    text. *)

val readable : ?tokens:(Source.t -> Tokens.t) -> Source.t -> Ast.model
(** Reads what can be read of a text with errors. A text without syntax errors gives its whole model; otherwise
    each whole declaration is read by itself. The result is empty if the text is not UTF-8 or nested too deeply.
    [tokens] is as in {!with_trivia}. *)

val expression : Source.t -> (Ast.expr, Diag.t list) result
(** Reads a number or formula that is the whole text. *)

val model_of : Tokens.t -> Source.t -> (Ast.model, Diag.t list) result
(** Reads a model from tokens. Their places are places in the given source. No declarations at all is a model,
    too. *)

val expression_of : Tokens.t -> Source.t -> (Ast.expr, Diag.t list) result
(** Reads a number or formula from tokens. Their places are places in the given source. *)
