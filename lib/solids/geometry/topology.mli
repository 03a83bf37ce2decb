(** The incidence of the vertices, edges and faces of a polyhedron, for walks over its surface. *)

type edge = {
  tail : int;
  head : int;  (** vertices; [tail < head] *)
  left : int;  (** the face that runs from [tail] to [head] *)
  right : int;  (** the face that runs from [head] to [tail] *)
}

type t = private {
  edges : edge array;  (** in the order given *)
  first : int array;  (** the neighbours of vertex [v] are at [first.(v)] to [first.(v + 1) - 1] *)
  neighbour : int array;
  along : int array;  (** the edge to the neighbour at the same place *)
}

val make : int -> int array array -> (int * int) array -> t
(** [make vertex_count faces edges] is the incidence of a closed surface (E1, E2). Linear time, up to the
    numbers of neighbours. *)

val edge_between : t -> int -> int -> int option
(** The edge with these two ends, in either order; [None] if there is none. *)

val common_face : t -> int -> int -> int -> int option
(** The face that has all three corners, which are distinct; [None] if there is none. *)
