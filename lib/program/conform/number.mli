(** Numbers in reports. *)

open Scc_exact

val decimal : Rat.t -> string
(** The number to nine digits. *)

val short : Rat.t -> string
(** The exact number if it is short, and the number to nine digits otherwise. *)
