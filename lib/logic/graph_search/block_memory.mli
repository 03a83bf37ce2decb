(** A cache of the results of changes of a block of a tuple: see {!Tuples}. Each place of the cache has the last
    entry that was put there. *)

type t

val create : unit -> t
(** [create ()] is an empty cache. *)

val find : t -> int -> int -> int -> int
(** [find t block one two] is the number of the block after the changes [one] and [two]; -1 if it is not in the
    cache. *)

val keep : t -> int -> int -> int -> int -> unit
(** [keep t block one two after] puts a result into the cache. Numbers are not negative; only [two] is -1 if there
    is one change. *)
