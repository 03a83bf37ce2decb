(** What may be wrong with the file of a picture. *)

open Scc_base

val malformed : path:string -> ('a, unit, string, ('b, Diag.t) result) format4 -> 'a
(** SC0340: it does not fit its format. *)

val unsupported : path:string -> ?hint:string -> ('a, unit, string, ('b, Diag.t) result) format4 -> 'a
(** SC0341: its format, or something in it, is not read. *)

val check_size : path:string -> width:int -> height:int -> (unit, Diag.t) result
(** SC0342 for more pixels than {!Raster} has; SC0340 for none. *)
