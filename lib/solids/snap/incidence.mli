(** The incidence of vertices and faces. Vertices and faces are elements of one kind. With the plane of a face
    as n . x = 1, the relation is symmetric in the vertex x and the plane n. *)

type t = private {
  vertices : int;
  faces : int array array;
  neighbours : int array array;
  (** of each element: vertex [v] is element [v], face [f] is element [vertices + f] *)
}

val make : vertices:int -> int array array -> t
(** [make ~vertices faces] is the incidence of faces, given as tuples of vertices, in range and each once. *)

val size : t -> int
(** The number of elements: vertices and faces together. *)
