(** Files of JSON Lines that are continued where they end: a header, and then numbered lines. *)

open Scc_base

val file : output:string option -> resume:string option -> string option
(** The file to write: that of [--output], or else the one that is continued. *)

val conflict :
  resume:string option -> store:string option -> part:Task_part.t option -> lines:bool -> string option
(** The reason why [--resume], [--store] and [--part] do not go together. [lines] is true if JSON Lines are
    written, or nothing for each task. *)

val lines :
  Console.t -> path:string -> header:string -> member:string -> what:string -> (int * string, Diag.t list) result
(** The number of whole lines after the header, whose [member] has the numbers 0, 1, …, and the text up to
    there. A line with the member [interrupted] true is not whole, and what follows it is left out. A file with
    another header (that of another [what]), or with other lines, is SC0804. *)

val bad : string -> ('a, unit, string, ('b, Diag.t list) result) format4 -> 'a
(** An error (SC0804) on the file. *)
