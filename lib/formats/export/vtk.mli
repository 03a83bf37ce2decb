(** A series for ParaView: a [.pvd] file that lists a [.vtp] file for each time, in a folder beside it. Each of
    these has the faces of all bodies and a line for each bond, in world coordinates, as the nearest floats of
    64 bits. *)

open Scc_exact

val folder : string -> string
(** The folder of the files of a series: its path without extension. *)

val files : Film.t -> path:string -> times:Rat.t list -> Film.file list
(** The files of the series at these times. The series itself has the extension [.pvd], whatever that of [path]
    is. *)
