(** What blocks of a tuple are after some changes, of those that were asked for last: see {!Tuples}. *)

type t

val create : unit -> t

val find : t -> int -> int -> int -> int
(** [find t block one two]: the block after the changes; -1 if it is not remembered. *)

val keep : t -> int -> int -> int -> int -> unit
(** [keep t block one two after]; numbers are not negative, but for [two], where one change is all. *)
