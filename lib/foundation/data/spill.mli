(** Large tables of numbers in memory, or beyond some size in mapped files: the system keeps pages that are not in
    use on disk, and reads them again when they are needed. The files have no names and end with the process.

    A forked process shares the mapped files: its writes to a table from before the fork show in its parent. So
    it must not write to such a table, and calls {!nowhere} first. *)

open Bigarray

val to_folder : string -> beyond:int -> unit
(** [to_folder path ~beyond] lets later tables be made in files of the folder [path], once the tables in memory
    have [beyond] bytes together. A table is made in memory if no file can be made, as on a full disk. *)

val nowhere : unit -> unit
(** [nowhere ()] lets later tables be made in memory; this is also how the program starts. *)

val takes : int -> bool
(** [takes bytes] is true if not all of so many bytes more would be made in memory. *)

val ints : int -> (int, int_elt, c_layout) Array1.t
(** [ints n] is a new table of [n] numbers of 8 bytes, with unspecified contents. *)

val int32s : int -> (int32, int32_elt, c_layout) Array1.t
(** [int32s n] is a new table of [n] numbers of 4 bytes, with unspecified contents. *)

val int16s : int -> (int, int16_signed_elt, c_layout) Array1.t
(** [int16s n] is a new table of [n] numbers of 2 bytes, with unspecified contents. *)
