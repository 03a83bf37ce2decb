(** One of several processes that explore a model together: it owns the states whose fingerprints, modulo the
    number of owners, are its number, and exchanges states with the others ([specs/successors.md]). *)

(** Which one it is, from 0, of how many. *)
type place = { number : int; count : int }

val run :
  Scc_successors.Filter.t -> place -> listener:Unix.file_descr -> program:string -> identity:string -> unit
(** [run filter place ~listener ~program ~identity] reads from standard input with whom it is to explore, and
    tells on standard output what was found. Others call it at [listener]. [program] is the version of scc, and
    [identity] is what is explored. It returns at the end of the input once it has told, or if there is none.
    Raises {!Failure.Failed} if the work fails because of others, and [Sys_error] if a file cannot be written. *)
