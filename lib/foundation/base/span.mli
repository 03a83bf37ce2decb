(** Places in source texts. *)

type t = private {
  file : string;  (** the name the user gave, never a resolved path *)
  start : int;  (** offset of the first byte *)
  stop : int;  (** offset after the last byte; [start <= stop] *)
}

val make : file:string -> start:int -> stop:int -> t
(** [make ~file ~start ~stop] is the span of the bytes from [start] to before [stop]. A [stop] before [start] is
    read as [start]. *)

val of_file : string -> t
(** [of_file file] is the empty span at the start of a file, for what is said of the whole file. *)

val merge : t -> t -> t
(** [merge a b] is the least span that covers both. Both must be of one file; that of [a] is kept. *)

val none : t
(** The span of a thing that no text contains. *)

val is_none : t -> bool
(** [is_none s] is true if [s] is {!none}. *)

val command_line : t
(** The span of errors in command line options, such as a value given by [-D] to a parameter that does not exist.
*)

val equal : t -> t -> bool
(** [equal a b] is true if file, start and stop are equal. *)
