(** Canonical numbers of components: by the order in which they first appear in an exploration. They do not depend
    on the numbers in this process, so two processes that explore the same states have the same canonical numbers.
*)

type t

val create : width:int -> family:(int -> int) -> t
(** [create ~width ~family] is a table without numbers, for tuples of this width. [family slot] is the family of a
    slot; slots of one family share their numbers. *)

val changes : t -> Tuples.changes -> Tuples.changes
(** [changes t c] is the changes [c] with canonical numbers. A component that has not appeared before gets the next
    number of its family. *)

val tuple : t -> int array -> int array
(** [tuple t numbers] is the tuple with the numbers of this process, for a tuple of canonical numbers. *)

val bytes : t -> int
(** [bytes t] is about how much memory the table takes, in bytes. *)
