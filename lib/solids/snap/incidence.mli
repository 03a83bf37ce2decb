(** Which vertices lie on which faces. Vertices and faces are elements of one kind: with the plane of a face as
    n . x = 1, a vertex x and a plane n lie on each other in the same way round. *)

type t = private {
  vertices : int;
  faces : int array array;
  neighbours : int array array;
  (** of each element: vertex [v] is element [v], face [f] is element [vertices + f] *)
}

val make : vertices:int -> int array array -> t
(** Of faces as tuples of vertices, in range and each once. *)

val size : t -> int
(** How many elements there are. *)

val pairs : t -> int
(** How many pairs of a vertex and a face that lie on each other. *)
