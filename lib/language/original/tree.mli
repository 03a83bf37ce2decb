(** The tree of a model in the original notation: that of [lib/language/syntax], in which regions stand where
    features do. What has no place there of its own is kept under names that no text can have, as they begin with a
    control character.

    A region is an expression: [X + Y], [X * Y] and [X - Y] are union, intersection and difference; what else
    there is, {!Region} tells. *)

open Scc_syntax

val feature : Ast.expr -> Ast.feature
(** The region, in the place of a feature. *)

val region : Ast.feature -> Ast.expr option

type declared =
  | Region of Ast.name * Ast.name * Ast.expr  (** [region R on S = X] *)
  | Curved of Ast.name * Ast.expr  (** [curved inscribed d]: the word, and the distance *)

val declared : Ast.item -> declared option
val item : declared -> Ast.item_kind

val keyword : [ `Region of string * string | `Curved of string ] -> string
(** The name of the declaration that {!declared} knows again: of the region on the shape, of the word. *)

val surface : string
(** The name of the feature that holds a region. *)

val at : Scc_base.Span.t -> 'a -> 'a Ast.loc
val path : Scc_base.Span.t -> string list -> Ast.path
val number : Scc_base.Span.t -> Scc_exact.Rat.t -> Ast.expr
(** As it is written: an integer, or a fraction of two; below zero as a negation. *)

val vector : Scc_base.Span.t -> Scc_exact.Vec.t -> Ast.expr
