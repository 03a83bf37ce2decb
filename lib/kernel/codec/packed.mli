(** Numbers as bytes, each in one way only (format: [specs/state-bytes.md]). Readers take nothing else. *)

open Scc_exact

(** {1 Writing} *)

val put_nat : Buffer.t -> int -> unit
(** Not negative. *)

val put_integer : Buffer.t -> Z.t -> unit
val put_rational : Buffer.t -> Rat.t -> unit
val put_vector : Buffer.t -> Vec.t -> unit

val put_list : Buffer.t -> (Buffer.t -> 'a -> unit) -> 'a list -> unit
(** Its length, and then each of them. *)

(** {1 Reading} *)

exception Malformed of string
(** What the bytes are not, in words. *)

type source

val source : ?from:int -> string -> source
(** From the byte of this place on, 0 by default. *)

val place : source -> int
(** Of the next byte. *)

val at_end : source -> bool

val nat : source -> int
val below : int -> what:string -> source -> int
(** Less than the limit. *)

val integer : source -> Z.t
val rational : source -> Rat.t
val vector : source -> Vec.t

val text : source -> string
(** A length, and so many bytes. *)

val list : source -> (source -> 'a) -> 'a list
(** Its length, and so many things of at least a byte each. *)
