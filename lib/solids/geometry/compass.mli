(** Start vertices for the climb to the vertex that is highest in a direction. *)

type t

val make : count:int -> highest:(float -> float -> float -> int) -> t
(** [make ~count ~highest] is the compass of a solid with [count] vertices, where [highest x y z] is the
    highest vertex in a direction, or nearly so. *)

val look : t -> float -> float -> float -> int
(** [look t x y z] is a vertex that is high in the direction, and in most cases the highest one. It is any
    vertex if the direction is 0 or has a NaN. *)
