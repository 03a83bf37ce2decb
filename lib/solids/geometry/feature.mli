(** Features of a polyhedron: vertices, edges and faces, by index (section 4.1 of the paper). *)

type t =
  | Vertex of int  (** index into {!Polyhedron.vertices} *)
  | Edge of int  (** index into {!Polyhedron.edges} *)
  | Face of int  (** index into {!Polyhedron.faces} *)

val dimension : t -> int
(** 0, 1 or 2. *)

val equal : t -> t -> bool

val compare : t -> t -> int
(** By dimension, then by index. *)

val hash : t -> int
