(** Tuples of one width, numbered as they are first seen, in a tree of pairs: a tuple is the pair of its two
    halves, each of which is stored once, whatever tuples share it. A new tuple that shares most of itself with
    known ones takes about 15 bytes (Laarman, van de Pol and Weber, Parallel Recursive State Compression for
    Free, 2011). *)

type t

val create : width:int -> t
(** At least 1. *)

val width : t -> int
val size : t -> int

(** A tuple spread out: its numbers, and those of its parts. *)
type spread

val spread : t -> spread
(** Room for one, which has no tuple yet. *)

val load : t -> spread -> int -> unit
(** Spreads out the tuple of a number. *)

val slots : spread -> int array
(** A fresh array of the tuple's numbers. *)

val read_slots : spread -> int array -> unit
(** Puts them into an array of as many, without making one. *)

(** What a tuple has in other places than another: places and numbers in [0, 2{^31}) by turns, each place once. *)
type changes = int array

val apply : changes -> int array -> int array
(** A fresh array. *)

val difference : int array -> int array -> changes
(** From the first to the second. *)

val intern : t -> near:spread -> changes -> int
(** The number of the tuple that differs by the changes from the one that has been loaded into [near] (if none
    has been, all places are given). It is new iff its number is the {!size} before. What the two share is not
    looked up. *)

val find : t -> near:spread -> changes -> int
(** -1 when it has not been seen. *)

(** {1 Without numbers} *)

val key : t -> near:spread -> changes -> int
(** A tuple as one number: the pair of its two halves, which are interned. The tuple is not. *)

val load_key : t -> spread -> int -> unit

(** {1 Several at once}

    The same as {!intern} of each in turn, in three rounds, so that what is far apart in memory is fetched at
    the same time. *)

val begin_round : t -> near:spread -> int -> unit
(** There will be at most so many, all near the same one. *)

val prepare : t -> near:spread -> lasting:bool -> changes -> int -> unit
(** [prepare t ~near ~lasting changes n]: the tuple of this number, from 0, of those that are to come. [lasting]:
    the same array of changes may come again, near other tuples. *)

val fetch : t -> int -> unit
(** So many have been prepared. *)

val prepared : t -> int -> int
(** The number, once it has been fetched; -1 of a tuple that was not known then. *)

val intern_prepared : t -> int -> int
(** Of one that was not known. *)

val bytes : t -> int
