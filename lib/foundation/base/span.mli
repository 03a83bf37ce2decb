(** Places in source texts. *)

type t = private {
  file : string;  (** the name the user gave, never a resolved path *)
  start : int;  (** offset of the first byte *)
  stop : int;  (** offset after the last byte; [start <= stop] *)
}

val make : file:string -> start:int -> stop:int -> t
(** [make ~file ~start ~stop]; a [stop] before [start] is read as [start]. *)

val merge : t -> t -> t
(** The least span that covers both; both must be of one file (the first's is kept). *)

val none : t
(** The span of what no text wrote. *)

val is_none : t -> bool

val command_line : t
(** Of what the command line says wrongly: a value given by [-D] to a parameter that there is not, say. *)

val equal : t -> t -> bool
