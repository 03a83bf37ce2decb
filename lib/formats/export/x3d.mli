(** X3D 3.3 as XML: bodies as Transforms, moved by PositionInterpolators and OrientationInterpolators from one
    TimeSensor, a second for each unit of time. The outermost Transform turns z up into the y up of X3D. *)

val file : Film.t -> (string -> unit) -> unit
