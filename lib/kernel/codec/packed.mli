(** Numbers as bytes, each in one form only (format: [specs/state-bytes.md]). Readers accept no other form; they
    raise {!Malformed} for it, and for bytes that end too early. *)

open Scc_exact

(** {1 Writing} *)

val put_nat : Buffer.t -> int -> unit
(** Appends an integer >= 0: 7 bits for each byte, the lowest first. *)

val put_integer : Buffer.t -> Z.t -> unit
(** Appends an integer of any size and sign. *)

val put_rational : Buffer.t -> Rat.t -> unit
(** Appends a rational number: its numerator, then its denominator, in lowest terms. *)

val put_vector : Buffer.t -> Vec.t -> unit
(** Appends the three components of a vector: x, y, z. *)

val put_list : Buffer.t -> (Buffer.t -> 'a -> unit) -> 'a list -> unit
(** [put_list buffer put list] appends the length of [list], and then each element by [put]. *)

(** {1 Reading} *)

exception Malformed of string
(** Bytes that no writer makes; the text is the reason. *)

type source

val source : ?from:int -> string -> source
(** [source ~from text] reads the bytes of [text] from index [from] on, by default from 0. *)

val place : source -> int
(** The index of the byte that is read next. *)

val at_end : source -> bool
(** [at_end s] is true if all bytes have been read. *)

val nat : source -> int
(** Reads an integer of {!put_nat}, below 2^56. *)

val below : int -> what:string -> source -> int
(** [below limit ~what s] reads an integer of {!put_nat} that must be less than [limit]. [what] names it in the
    message. *)

val integer : source -> Z.t
(** Reads an integer of {!put_integer}. *)

val rational : source -> Rat.t
(** Reads a rational number of {!put_rational}, with a positive denominator and in lowest terms. *)

val vector : source -> Vec.t
(** Reads the three components of a vector. *)

val text : source -> string
(** Reads a length, and a text of as many bytes. *)

val list : source -> (source -> 'a) -> 'a list
(** [list s item] reads a list of {!put_list}, each element by [item]. Each element must take at least one byte. *)
