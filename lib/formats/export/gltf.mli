(** glTF 2.0, binary: bodies as nodes of their parts, their motion as an animation of one second for each unit of
    time. The root turns z up into the y up of glTF. Numbers are floats of 32 bits. *)

val file : Film.t -> (string -> unit) -> unit
