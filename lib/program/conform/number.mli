(** Numbers of reports, for people. *)

open Scc_exact

val decimal : Rat.t -> string
(** To nine digits. *)

val short : Rat.t -> string
(** Exact if that is short, else to nine digits. *)
