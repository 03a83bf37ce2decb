(** A cache of the results of changes of a half of a tuple: see {!Tuples}.

    The transitions of two states with a half in common mostly come in equal order, as far as they change that half
    alone. So the cache compares only with the change that came next the last time. *)

type t

val create : unit -> t
(** [create ()] is an empty cache. *)

val start : t -> int -> unit
(** [start t half] begins with the half of this number: the next calls of {!find} and {!keep} are about it. *)

val find : t -> int array -> int
(** [find t changes] is the number kept for the changes, if they came next the last time; -1 if not. Changes are
    compared by physical equality of the array. *)

val keep : t -> int array -> int -> unit
(** [keep t changes after] stores the number of the half after changes that {!find} did not know: any number but
    -1. *)
