(** Sizes of memory in bytes, in MiB, and in words as OCaml counts its heap. *)

val mib : int
(** The bytes of one MiB: 2{^20}. *)

val words_of_mib : int -> int
(** [words_of_mib n] is how many words fit into [n] MiB. *)

val words_of_bytes : int -> int
(** [words_of_bytes n] is how many words fit into [n] bytes, rounded down. *)

val bytes_of_words : int -> int
(** [bytes_of_words n] is the size of [n] words in bytes. *)

val heap_words : unit -> int
(** [heap_words ()] is the present size of the major heap of OCaml, in words. *)

(** {1 How often garbage is collected} *)

val spare_tables : unit -> unit
(** Makes major collections rarer than OCaml does by default, and nearly independent of how much memory tables
    outside of the heap take. The tables of an exploration stay until its end, as does most of the heap. *)

val spare_runs : unit -> unit
(** Makes major collections still rarer: runs keep little of what they allocate, so that this costs hardly any
    memory. *)

(** {1 Other processes} *)

val beside : unit -> int
(** [beside ()] is the size of the heaps of all worker processes of this one, in bytes, as {!set_beside} left it; 0
    at first. *)

val set_beside : int -> unit
(** [set_beside bytes] sets what {!beside} returns. *)
