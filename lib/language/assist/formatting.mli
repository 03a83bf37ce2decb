(** Canonical layout of a part of a text. *)

open Scc_base

(** What replaces the text between two offsets. *)
type edit = { start : int; stop : int; put : string }

val within : Source.t -> from:int -> upto:int -> (edit option, Diag.t list) result
(** [within source ~from ~upto] lays out the declarations that the text between two offsets touches, as
    {!Scc_notation.Notation.canonical} lays them out. Only whole declarations on whole lines are replaced: others
    that share these lines belong with them, and so do comments that move from one declaration to another. It is
    [None] if no declaration is touched. The errors are those of the text. *)
