(** Numbers that two sides have for the same things, as bytes: the bytes of a thing are told once, when it first
    comes up, and from then on it is a number that both know. *)

open Scc_codec

type t

val create : unit -> t

val put : t -> Buffer.t -> bytes:(int -> string) -> int -> unit
(** A thing by the number that it has on this side; [bytes] gives its bytes, if they are to be told. *)

val read : t -> Packed.source -> number:(string -> int) -> int
(** The number that a thing has on this side; [number] gives it from its bytes. What was read may be {!put} again.
    Raises {!Packed.Malformed}. *)

val knows : t -> int -> bool
(** Whether the thing has come up that has this number here. *)
