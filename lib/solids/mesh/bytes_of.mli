(** Numbers in binary mesh files. Offsets are in range (a bug otherwise). *)

open Scc_base
open Scc_exact

val unsigned : big_endian:bool -> string -> int -> int -> int
(** [unsigned ~big_endian text offset width] of 1, 2 or 4 bytes. *)

val signed : big_endian:bool -> string -> int -> int -> int

val real : path:string -> big_endian:bool -> string -> int -> int -> (Rat.t, Diag.t) result
(** The exact value of an IEEE number of 4 or 8 bytes; NaN and the infinities are errors. *)
