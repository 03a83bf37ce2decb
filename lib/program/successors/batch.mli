(** Many states at once, in columns of numbers: for programs that have no time to read texts. The format is told in
    [specs/successors.md]. *)

open Scc_base

type t

val make : Filter.t -> t
val most : int
(** The greatest length of a frame, in bytes. *)

val answer : t -> string -> Buffer.t -> (unit, Diag.t) result
(** [answer t frame out] writes to [out] the frame, with its length, that answers one, without its length. SC0921
    where that does not fit its format: nothing is written. *)
