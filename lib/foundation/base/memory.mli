(** Sizes of memory: bytes, words of the heap as OCaml counts them, and MiB as people do. *)

val mib : int
(** Bytes. *)

val words_of_mib : int -> int
val words_of_bytes : int -> int
(** Rounded down. *)

val bytes_of_words : int -> int

val heap_words : unit -> int
(** What the heap takes now. *)

(** {1 How often garbage is looked for} *)

val spare_tables : unit -> unit
(** Less often than OCaml would, and not the more often, the more there is in tables outside of its heap: those of
    an exploration stay until its end, as most of what is in the heap does. *)

val spare_runs : unit -> unit
(** Less often: runs keep little of what they make, so that it takes hardly more memory. *)

(** {1 Other processes} *)

val beside : unit -> int
(** Bytes of the heaps of other processes that work for this one. *)

val set_beside : int -> unit
