(** Files of JSON Lines that are gone on with where they end: a header, and then lines that are numbered. *)

open Scc_base

val lines :
  path:string -> header:string -> member:string -> what:string -> (int * string, Diag.t list) result
(** How many whole lines with the numbers 0, 1, ... in this member there are after the header, and the text up to
    there. SC0804 for a file with another header, which is that of another [what], or with other lines. *)

val bad : string -> ('a, unit, string, ('b, Diag.t list) result) format4 -> 'a
(** SC0804 about the file. *)
