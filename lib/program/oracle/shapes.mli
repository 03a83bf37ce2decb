(** The methods [shape.*]: shapes as handles, reports on sets of faces, mass properties. *)

open Scc_geometry

type store
(** The shapes of a session, and obstacles of pairs of them that were asked for, which only save time. *)

val store : Quotas.t -> store

val shape : store -> Solid.t Read.reader
(** Of a handle. *)

val obstacle : store -> Solid.t -> Solid.t -> Obstacle.t

val tidy : store -> Obstacle.t -> unit
(** After the use of an obstacle: forgets one that has become large. *)

val forget : store -> unit
(** All obstacles: one may have been left half made. *)

val define : store -> Read.params -> Reply.t
val check : Read.params -> Reply.t
val mass : store -> Read.params -> Reply.t
val release : store -> Read.params -> Reply.t
