(** Numbers in binary mesh files. Offsets are in range (a bug otherwise). *)

open Scc_base
open Scc_exact

val unsigned : big_endian:bool -> string -> int -> int -> int
(** [unsigned ~big_endian text offset width] is the unsigned integer of 1, 2 or 4 bytes at the offset. Another
    width is a bug. *)

val signed : big_endian:bool -> string -> int -> int -> int
(** [signed ~big_endian text offset width] is the integer of 1, 2 or 4 bytes at the offset, in two's
    complement. Another width is a bug. *)

val real : path:string -> big_endian:bool -> string -> int -> int -> (Rat.t, Diag.t) result
(** [real ~path ~big_endian text offset width] is the exact value of an IEEE number of 4 or 8 bytes. NaN and
    the infinities are errors (SC0320). *)
