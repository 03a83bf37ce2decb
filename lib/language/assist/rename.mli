(** New names for what a text declares. A new name is taken only if every name of the text means the same
    afterwards: the changed text is read again, and compared. *)

open Scc_base
open Scc_describe

type edit = Span.t * string
(** What replaces a part of a text. *)

val apply : string -> edit list -> string
(** The text after all edits, which do not overlap. *)

val edits : Reading.t -> Names.target -> string -> (edit list, string) result
(** The edits that give a target a new name in this text. The error says why the name cannot be taken: the text has
    errors of syntax, another declaration has the name, or some name would change its meaning. *)
