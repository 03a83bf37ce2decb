(** The methods [shape.*]: shapes by handle, reports on sets of faces, mass properties. *)

open Scc_geometry

type store
(** The shapes of a session, with a cache of obstacles of pairs. *)

val store : Quotas.t -> store
(** No shapes yet. *)

val handle : string Read.reader
(** Reads the handle of a shape. *)

val get : store -> Read.params -> string Read.member -> Solid.t
(** The shape of the handle that is a member of the params. *)

val obstacle : store -> Solid.t -> Solid.t -> Obstacle.t
(** The obstacle of two shapes, from the cache if possible. *)

val tidy : store -> Obstacle.t -> unit
(** Removes an obstacle from the cache if it has become large. It must be called after the use of an
    obstacle. *)

val forget : store -> unit
(** Removes all obstacles from the cache, which may be incomplete. *)

(** {1 Methods} *)

val define : store Method.t
(** The method [shape.define]. *)

val check : unit Method.t
(** The method [shape.check]. *)

val mass : store Method.t
(** The method [shape.mass]. *)

val release : store Method.t
(** The method [shape.release]. *)
