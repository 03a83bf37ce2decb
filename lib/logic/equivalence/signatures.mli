(** Sets of numbers, each distinct set once: what {!Refine} tells states apart by. Sets live until {!clear}. *)

type t

val create : unit -> t

val clear : t -> unit
(** Forgets every set, at a cost in proportion to them. *)

(** {1 Writing a set}

    Numbers are added in any order, with repetitions. *)

val start : t -> unit
val add : t -> int -> unit

val within : t -> except:int -> int -> bool
(** Whether what was added so far, but for the number [except], are members of a set that has a number. *)

val finish : t -> int
(** The number of the set that was written, from 0 in the order of first appearance. *)

val count : t -> int
(** How many distinct sets there are. *)
