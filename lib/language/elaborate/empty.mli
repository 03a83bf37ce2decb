(** What a model says of families without members. Declarations in a loop over an empty range are not elaborated,
    and neither are quantifiers over nothing. The names in them are in use all the same. *)

open Scc_syntax

(** The names in use. *)
type t

val make : Ast.model -> reached:(int -> bool) -> t
(** [make model ~reached] is what the model says. [reached start] is true if the loop that begins at that byte has
    made a declaration. *)

val mentions : t -> string -> bool
(** [mentions t name] is true if the name is in a declaration in an empty loop, in the law of some bodies, or in
    what is quantified or chosen over a range, or in a declaration that one of these mentions. *)

val channels : t -> string list
(** The channels of bonds and behaviours in empty loops, and of behaviours that these mention. *)
