(** The names in a text, and the meaning of each. Nothing is computed, so the text may be full of errors. *)

open Scc_syntax

(** All names of a text. *)
type t = Scope.t

val of_model : Declared.all -> Ast.model -> t
(** The names of a text with these declarations. *)

val at : t -> int -> Scope.use option
(** The use whose name begins at an offset. *)

val channel : t -> string -> Scope.channel_use list
(** The places at which a channel of this name is named, in the order of the text. *)
