(** The method [response]: the velocities and spins after a collision. *)

val response : Shapes.store Method.t
(** The method [response]. Pairs that do not touch are refused ([Not_in_contact]); with [resolution] the bodies
    may turn. *)
