(** The tree of a model in the original notation. It is that of [lib/language/syntax], with regions in the place
    of features. Parts without a place of their own have names that begin with a control character, which no
    text contains.

    A region is an expression: [X + Y], [X * Y] and [X - Y] are union, intersection and difference. [Region]
    lists the other forms. *)

open Scc_syntax

val feature : Ast.expr -> Ast.feature
(** The region in the place of a feature. *)

val region : Ast.feature -> Ast.expr option
(** The region that stands in the place of a feature, if it does. *)

(** A declaration of the original notation alone. *)
type declared =
  | Region of Ast.name * Ast.name * Ast.expr  (** [region R on S = X] *)
  | Curved of Ast.name * Ast.expr  (** [curved inscribed d]: the word, and the distance *)

val declared : Ast.item -> declared option
(** The declaration of the original notation that an item stands for, if it does. *)

val item : declared -> Ast.item_kind
(** The item that stands for a declaration; {!val-declared} reads it back. *)

val keyword : [ `Region of string * string | `Curved of string ] -> string
(** The name of the value that stands for a declaration, by region and shape or by the word after [curved]. *)

val surface : string
(** The name of the feature that contains a region. *)

val at : Scc_base.Span.t -> 'a -> 'a Ast.loc
(** [at span x] is [x] at this place. *)

val path : Scc_base.Span.t -> string list -> Ast.path
(** [path span names] is a path of names without indices. *)

val number : Scc_base.Span.t -> Scc_exact.Rat.t -> Ast.expr
(** [number span q] is [q] as an expression: an integer, or a fraction of two. A negative number is a
    negation. *)

val vector : Scc_base.Span.t -> Scc_exact.Vec.t -> Ast.expr
(** [vector span v] is [v] as an expression, with components by {!number}. *)
