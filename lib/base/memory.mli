(** Sizes of memory: bytes, words of the heap as OCaml counts them, and MiB as people do. *)

val mib : int
(** Bytes. *)

val words_of_mib : int -> int
val words_of_bytes : int -> int
(** Rounded down. *)

val bytes_of_words : int -> int

val heap_words : unit -> int
(** What the heap takes now. *)

val beside : unit -> int
(** Bytes of the heaps of other processes that work for this one. *)

val set_beside : int -> unit
