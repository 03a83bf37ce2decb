(** [lib/kernel/semantics], which DEVEL.md promises to be the rule book as a program. *)

val impure : unit -> string list
(** Lines outside of comments that mutate, use floats, keep tables or search. *)

val unlisted : unit -> string list
(** Modules without a row in the reading list of DEVEL.md, and rows without a module. *)
