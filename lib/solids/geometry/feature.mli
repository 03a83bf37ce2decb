(** Features of a polyhedron: vertices, edges and faces, by index (section 4.1 of the paper). *)

type t =
  | Vertex of int  (** index into {!Polyhedron.vertices} *)
  | Edge of int  (** index into {!Polyhedron.edges} *)
  | Face of int  (** index into {!Polyhedron.faces} *)

val dimension : t -> int
(** The dimension of a feature: 0 for a vertex, 1 for an edge, 2 for a face. *)

val equal : t -> t -> bool
(** [equal f g] is true if both are features of one kind with one index. *)

val compare : t -> t -> int
(** A total order: by dimension, then by index. *)

val hash : t -> int
(** A hash that is compatible with {!equal}. *)
