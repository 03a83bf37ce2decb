(** The statement [UNIT] of X3D. *)

val check : path:string -> Text.word -> category:string -> factor:Text.word -> unit
(** [check ~path at ~category ~factor] raises {!Scene.Refused} if the unit changes angles. Units of length,
    mass and force leave the numbers of the file as they are, in which its solid is read. *)
