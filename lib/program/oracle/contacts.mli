(** The methods [contact] and [first_time_of_contact]: two shapes, the reference point of the first at the
    origin. *)

val contact : Shapes.store -> Read.params -> Reply.t
val first_time_of_contact : Shapes.store -> Read.params -> Reply.t

val relation : Scc_geometry.Obstacle.relation -> string
