(** Numbers that a text gives plainly: literals, earlier [let]s with such values, and [+], [-], [*] and [/] of
    these. Parameters are not plain, since a run of the model may give them other values. *)

open Scc_base
open Scc_exact
open Scc_syntax

(** The plain constants of a text, by name. *)
type t

val none : t
(** No constants. *)

val of_model : Ast.model -> t
(** The constants that a text declares. A name with another meaning somewhere in the text is left out. Such a
    name is also a parameter of a shape or behaviour, a value after [where], a loop index, or a [let] in a
    loop. *)

val number : t -> Ast.expr -> (Rat.t, Span.t) result
(** The value of a plain number. The error is the place of the first part that is not plain. *)

val vector : t -> Ast.expr -> (Vec.t, Span.t) result
(** The value of a plain vector. The error is the place of the first part that is not plain. *)
