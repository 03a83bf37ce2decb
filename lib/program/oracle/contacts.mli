(** The methods [contact] and [first_time_of_contact] for two shapes. The reference point of the first is the
    origin. *)

val contact : Shapes.store Method.t
(** The method [contact]: the relation of two shapes at an offset, and where they touch. *)

val first_time_of_contact : Shapes.store Method.t
(** The method [first_time_of_contact] of two shapes in relative motion. With [span] or [until] they may also
    turn. *)

val relation : Scc_geometry.Obstacle.relation -> string
(** The name of a relation: ["apart"], ["touching"] or ["interpenetrating"]. *)
