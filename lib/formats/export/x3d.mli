(** X3D 3.3 as XML. Bodies are Transforms, moved by PositionInterpolators and OrientationInterpolators from one
    TimeSensor, with one second per unit of time. The outermost Transform turns z up into the y up of X3D. *)

val file : Film.t -> (string -> unit) -> unit
(** Writes the file of a run. Raises {!Floats.Too_great}. *)
