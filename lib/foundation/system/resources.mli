(** Resources of which the system has no more: memory, processes, descriptors of files. *)

(** The limits of the system on a process: on its addresses ([ulimit -v]), its data ([-d]) and its stack
    ([-s]). *)
type limit = Addresses | Data | Stack

val limit : limit -> int option
(** [limit which] is the limit in bytes; [None] if the system sets none. *)

val refused : exn -> string option
(** [refused e] is the resource that is lacking, in words, if [e] is an exception for the lack of one; otherwise
    [None]. A stack that overflows is lacking only under a limit on the memory of the process, or on its stack
    below the 1 MiB with which every command works. *)
