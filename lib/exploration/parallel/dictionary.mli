(** Common numbers of two sides for the same things. The bytes of a thing are sent once, when it first occurs;
    from then on both sides use its common number. *)

open Scc_codec

type t

val create : unit -> t
(** A dictionary without entries. Both sides begin with one. *)

val put : t -> Buffer.t -> bytes:(int -> string) -> int -> unit
(** [put d buffer ~bytes number] appends the thing that has [number] on this side. [bytes number] gives its
    bytes, which are appended if the thing has no common number yet. *)

val read : t -> Packed.source -> number:(string -> int) -> int
(** [read d source ~number] reads a thing and returns its number on this side. [number] gives the number from the
    bytes, if these are in the source. What was read may be {!put} by its common number. Raises
    {!Scc_codec.Packed.Malformed}. *)

val knows : t -> int -> bool
(** [knows d number] is true if the thing that has [number] on this side has a common number. *)
