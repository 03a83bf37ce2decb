(** The modules that are part of the program, for [import <solids>]. *)

val names : string list
(** The names of the modules. *)

val find : string -> string option
(** The text of a module. *)
