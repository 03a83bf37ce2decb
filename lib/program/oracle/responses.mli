(** The method [response]: what a collision does to velocities and spins. *)

val response : Shapes.store -> Read.params -> Reply.t
