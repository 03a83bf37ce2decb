(** The modules that come with the program: [import <solids>]. Their texts are part of it. *)

val names : string list

val find : string -> string option
(** The text of a module. *)
