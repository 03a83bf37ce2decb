(** A {!Log} that is written while something goes on: what is noted is gathered, and kept in blocks. *)

type t

val make : ?full:int -> Log.t -> t
(** A block is written when it has [full] bytes, a MiB by default, or a while after the one before, a second at
    most: little is lost of what takes long, and writing takes little of the time of any. *)

val is_empty : t -> bool
(** What is noted next begins a block. *)

val add : t -> (Buffer.t -> unit) -> unit
(** Notes the bytes that it puts, in one block. *)

val write : t -> unit
(** What has been gathered, if anything. *)
