(** Faces that are there twice. *)

val from_least : int array -> int list
(** [from_least corners] are the corners from the least one on, in their direction. *)

val single : (string * int array) list -> (string * int array) list
(** [single faces] are the faces, of which those that are there twice, with the same corners in one direction,
    may be there once. So many stay as the faces around them need: an edge is to have as many faces that run
    along it one way as the other way. A face that nothing around it decides stays once, as in a closed surface
    that is there twice. Where faces do not agree in direction, an even number of faces at each edge is enough.
    The first ones stay. *)
