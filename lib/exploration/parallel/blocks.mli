(** A {!Log} that is written during a computation: notes are gathered, and kept in blocks. *)

type t

val make : ?full:int -> Log.t -> t
(** [make ~full log] writes a block to [log] once it has [full] bytes, by default 1 MiB, or some time after the
    last block. That time is at most a second, so little is lost of slow computations. It grows with the time
    that writing takes, so writing takes a small part of the whole. *)

val add : t -> (Buffer.t -> unit) -> unit
(** [add b put] gathers the bytes that [put] appends, in one block, and writes the block if it is time. *)

val write : t -> unit
(** Writes the block that has been gathered, if it has any bytes. *)
