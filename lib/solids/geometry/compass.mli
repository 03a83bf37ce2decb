(** Where to begin the climb to the vertex that is highest in a direction. *)

type t

val make : count:int -> highest:(float -> float -> float -> int) -> t
(** [make ~count ~highest]: of a solid with [count] vertices, whose highest one in a direction is [highest x y z]
    (or nearly so). *)

val look : t -> float -> float -> float -> int
(** A vertex that is high in the direction, more often than not the highest; any vertex for a direction that
    is 0 or no number. *)
