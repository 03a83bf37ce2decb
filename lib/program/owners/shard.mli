(** The states of an owner in files: each file has some levels, and says how many were there before. *)

val write : string -> Part.t -> Levels.t -> Progress.t -> from:int -> unit
(** [write path part levels progress ~from] writes the levels from [from] on, and how far the exploration has
    come. Raises [Sys_error]. *)

val read : string -> Part.t -> Levels.t -> Progress.t
(** [read path part levels] adds what a file has to what the files before it had, and returns how far the
    exploration had come. Raises {!Failure.Failed} if it is no such file. *)
