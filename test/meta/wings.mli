(** The wings of [lib/]: each has a README that names its rooms (libraries) and the wings that it may use. *)

val all : unit -> string list
(** The folders of [lib/] with a README, in the order of the table in DEVEL.md. *)

val field : string -> string -> string list
(** [field name text] are the words of the first field of that name in the text of a dune file. *)

val upward : string -> string list
(** Edges from a library of this wing to a wing that its README does not allow. *)

val unordered : unit -> string list
(** Wings that allow a wing of a later line of that table, or themselves. *)

val unused : string -> string list
(** Edges from a library of this wing to a library that its sources do not name. *)

val reaches : from:string list -> wing:string -> string list
(** Edges into a room of the wing from a library among [from], or from one on which they depend. *)

val unnamed : string -> string list
(** Rooms of this wing that its README does not name, and those that it names in vain, or twice. *)

val misplaced : string -> string list
(** Files that its README names between backquotes and that are not there. *)

val too_long : string -> string list
(** Whether its README is more than a page of 60 lines. *)
