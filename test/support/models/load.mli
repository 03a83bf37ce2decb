(** Models from text, all the way to the terms of the calculus. *)

open Scc_base
open Scc_exact

val text :
  ?name:string -> ?overrides:(string * Rat.t) list -> string -> (Scc_elaborate.Elaborate.t, Diag.t list) result
(** No mesh can be read. *)

val file :
  ?overrides:(string * Rat.t) list -> string -> (Scc_elaborate.Elaborate.t, Diag.t list) result
(** Meshes are found relative to the file. *)

val exactly : ('a, Diag.t list) result -> 'a
(** Fails with the rendered diagnostics. *)

val read : string -> string
(** The bytes of a file. *)
