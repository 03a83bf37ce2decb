(** Tables of tuples of one width, numbered in the order of insertion and stored in a tree of pairs. A tuple is the
    pair of its two halves; each half is stored once, whatever tuples share it. A new tuple that shares most of
    itself with known ones takes about 15 bytes (Laarman, van de Pol and Weber, Parallel Recursive State
    Compression for Free, 2011). *)

type t

val create : width:int -> t
(** [create ~width] is an empty table for tuples of [width] numbers. [width] is at least 1 (a bug otherwise). *)

val size : t -> int
(** [size t] is the number of tuples. *)

(** Working memory for a tuple with the numbers of all its parts. *)
type spread

val spread : t -> spread
(** [spread t] is new working memory, without a tuple yet. *)

val load : t -> spread -> int -> unit
(** [load t s i] loads the tuple with number [i] into [s]. *)

val slots : spread -> int array
(** [slots s] is the numbers of the loaded tuple, as a new array. *)

val read_slots : spread -> int array -> unit
(** [read_slots s room] puts the numbers of the loaded tuple into [room], which has [width] elements (a bug
    otherwise). *)

(** The difference of a tuple from another: slots and their new numbers (at least 0, below 2{^31}) by turns, each
    slot at most once. *)
type changes = int array

val apply : changes -> int array -> int array
(** [apply changes tuple] is the tuple after the changes, as a new array. *)

val difference : int array -> int array -> changes
(** [difference a b] is the changes from tuple [a] to tuple [b], by increasing slots. *)

val intern : t -> near:spread -> changes -> int
(** [intern t ~near changes] is the number of the tuple that differs by the changes from the one loaded into
    [near]. If none is loaded, the changes give all slots. The tuple is inserted if it is new, which holds iff its
    number is the {!size} before. Parts that the two tuples share are not looked up. *)

val find : t -> near:spread -> changes -> int
(** [find t ~near changes] is the number of the tuple that {!intern} would return; -1 if it is not in the table. *)

(** {1 Without numbers} *)

val key : t -> near:spread -> changes -> int
(** [key t ~near changes] is the tuple as one number: the pair of its two halves, which are inserted. The tuple
    itself is not inserted. *)

val load_key : t -> spread -> int -> unit
(** [load_key t s key] loads the tuple of a {!key} into [s]. *)

(** {1 Several at once}

    Several tuples are interned in three rounds, with the results of {!intern} of each in turn. Places that are far
    apart in memory are then fetched at the same time. *)

val begin_round : t -> near:spread -> int -> unit
(** [begin_round t ~near count] begins with at most [count] tuples, all near the one loaded into [near]. *)

val prepare : t -> near:spread -> lasting:bool -> changes -> int -> unit
(** [prepare t ~near ~lasting changes n] gives the changes of the [n]-th tuple of the round, from 0. With [lasting]
    the same array of changes may come again, near other tuples. *)

val fetch : t -> int -> unit
(** [fetch t count] looks up the tuples of the round, [count] of which have been prepared. *)

val prepared : t -> int -> int
(** [prepared t n] is the number of the [n]-th tuple of the round after {!fetch}; -1 if it was not in the table
    then. *)

val intern_prepared : t -> int -> int
(** [intern_prepared t n] is the number of the [n]-th tuple of the round, which is inserted if it is still new. *)

val prepared_key : t -> int -> int
(** [prepared_key t n] is the {!key} of the [n]-th tuple of the round. *)

val intern_key : t -> int -> int
(** [intern_key t key] is the number of the tuple with this {!key}, which is inserted if it is new. *)

val find_key : t -> int -> int
(** [find_key t key] is the number of the tuple with this {!key}; -1 if it is not in the table. *)

(** {1 Several processes}

    Processes that are forked after {!share} have the parts of tuples in common. One process inserts tuples, all
    others look them up and insert their parts. *)

val share : t -> bool
(** [share t] moves the table into memory that processes share. If it is false, the system gives no such memory, and
    the table must not be used by several. *)

val unshare : t -> unit
(** [unshare t] moves the table back to this process alone. No other process may use it any more. *)

val touch_key : t -> int -> int
(** [touch_key t key] makes {!intern_key} fast that follows soon. The result means nothing. *)

val refresh : t -> unit
(** [refresh t] is called by a process before it looks for tuples that others have inserted. *)

val is_room_wanted : t -> bool
(** [is_room_wanted t] is true if {!make_room} should be called soon. *)

val make_room : t -> unit
(** [make_room t] makes room for more parts. No other process may insert any meanwhile, and all refresh before they
    do so again. It raises {!Limits.Over} if there is no more memory. *)

val go_on_apart : t -> full:(unit -> unit) -> unit
(** [go_on_apart t ~full] is called by a process that has been forked, before it uses a shared table. [full] is as for
    {!set_full}. *)

val set_full : t -> (unit -> unit) -> unit
(** [set_full t full]: this process calls [full] where a part does not fit. It calls {!make_room}, or raises. *)

val bytes : t -> int
(** [bytes t] is about how much memory the table takes, in bytes. *)
