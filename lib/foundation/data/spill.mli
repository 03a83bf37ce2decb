(** Large tables of numbers, in memory, or beyond some size in files that are mapped: what is not needed of those
    the system keeps on disk alone, and fetches again when it is. The files have no names and end with the
    process.

    A process that is forked has the same files, and what it writes to a table of before shows on the other side:
    it must not write to any, and begins with {!nowhere}. *)

open Bigarray

val to_folder : string -> beyond:int -> unit
(** From now on tables are made in files of this folder, once those in memory have so many bytes together. *)

val nowhere : unit -> unit
(** From now on they are made in memory. *)

val ints : int -> (int, int_elt, c_layout) Array1.t
(** A table of so many numbers, whatever they are. *)

val int32s : int -> (int32, int32_elt, c_layout) Array1.t
val int16s : int -> (int, int16_signed_elt, c_layout) Array1.t

val on_disk : unit -> int
(** The bytes of all files made so far. *)
