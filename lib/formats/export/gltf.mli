(** glTF 2.0, binary. Bodies are nodes with their parts, and their motion is an animation of one second per unit
    of time. The root turns z up into the y up of glTF. Numbers are floats of 32 bits. *)

val file : Film.t -> (string -> unit) -> unit
(** Writes the file of a run. Raises {!Floats.Too_great}. *)
