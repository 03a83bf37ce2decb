(** Resources of which the system has no more: memory, processes, descriptors of files. *)

val refused : exn -> string option
(** [refused e] is the resource that is lacking, in words, if [e] is an exception for the lack of one; otherwise
    [None]. *)
