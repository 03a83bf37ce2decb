(** A series for ParaView: a [.pvd] file that names, for each time, a [.vtp] file of a folder beside it. Each has
    the faces of all bodies and a line for each bond, in world coordinates, the nearest floats of 64 bits. *)

open Scc_exact

val folder : string -> string
(** Of the files of a series, by the path that was asked for. *)

val files : Film.t -> path:string -> times:Rat.t list -> Film.file list
(** Whatever the ending of the path is, the series has [.pvd]. *)
