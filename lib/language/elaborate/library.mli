(** The modules that are part of the program, for [import <solids>]. *)

val names : string list
(** The names of the modules. *)

val find : string -> string option
(** The text of a module. *)

val declaring : string -> string -> string option
(** [declaring kind name] is the module that declares a ["template"] or a ["behaviour"] of this name, at the
    beginning of a line of its text. *)
