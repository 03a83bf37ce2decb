(** Faults of the file of a picture. *)

open Scc_base

val malformed : path:string -> ('a, unit, string, ('b, Diag.t) result) format4 -> 'a
(** An error SC0340: the file violates its format. *)

val unsupported : path:string -> ?hint:string -> ('a, unit, string, ('b, Diag.t) result) format4 -> 'a
(** An error SC0341: the format, or a feature of it, is not supported. *)

val check_size : ?cure:string -> path:string -> width:int -> height:int -> unit -> (unit, Diag.t) result
(** The check of a size: SC0342 for more pixels than {!Raster} permits, SC0340 for none. The hint says [cure], or
    else to make the picture smaller. *)
