(** Numbers of components by the order in which they first appear in what is found, whatever numbers a process has
    given to them: two processes that find the same have the same numbers. *)

type t

val create : width:int -> family:(int -> int) -> t
(** Of tuples of this width. [family]: of a slot; slots of one family share their numbers. *)

val changes : t -> Tuples.changes -> Tuples.changes
(** With numbers by appearance. What has not appeared before does so now. *)

val tuple : t -> int array -> int array
(** The tuple, of which these are the numbers by appearance, with those of the process. *)

val bytes : t -> int
