(** Tables of pairs of small integers, numbered in the order of insertion. A pair takes 8 bytes, or 4 if its
    numbers are less than 2{^16}, and 5 to 11 bytes in the index. *)

type t

val create : in_files:bool -> t
(** [create ~in_files] is an empty table. With [in_files] its memory may be in files ({!Scc_data.Spill}): then no
    other process may share it. *)

val size : t -> int
(** [size p] is the number of pairs. *)

val intern : t -> int -> int -> int
(** [intern p a b] is the number of the pair (a, b), which is inserted if it is new. [a] and [b] are at least 0
    and below 2{^31} (a bug otherwise). Pairs are numbered from 0 in the order of insertion, so a pair is new iff
    its number is the {!size} before. *)

val find : t -> int -> int -> int
(** [find p a b] is the number of the pair (a, b); -1 if it is not in the table. *)

(** {1 Many at once} *)

val pack : int -> int -> int
(** [pack a b] is the pair (a, b) as one number, its key. [a] and [b] are as for {!intern}. *)

val intern_key : t -> int -> int
(** [intern_key p key] is {!intern} of a packed pair. *)

val find_key : t -> int -> int
(** [find_key p key] is {!find} of a packed pair. *)

val find_keys : t -> int array -> int array -> int -> unit
(** [find_keys p keys ids n] puts the numbers of the first [n] packed pairs into [ids], -1 for a pair that is not
    in the table. Their places, which are far apart in memory, are fetched at the same time. *)

(** {1 Tables that processes share}

    Processes that are forked after {!share} have the table in common: what one of them inserts, all others find. *)

val share : t -> many:bool -> bool
(** [share p ~many] moves the table into memory that is shared. With [many] all processes may insert, and numbers
    need not follow each other; else one of them may, and the others find. It is false, and nothing has changed, if
    the system gives no such memory. *)

val unshare : t -> unit
(** [unshare p] moves the table back into memory, or files, of this process alone. No other process may use it any
    more. *)

val touch : t -> int -> int
(** [touch p key] looks where the pair with this key would be, so that {!find_key} does not wait for memory soon after.
    The result means nothing. *)

val refresh : t -> unit
(** [refresh p] is called by a process that shares the table, now and then: its index may have become larger. Until
    then the process does not find pairs that were inserted since. *)

val is_room_wanted : t -> bool
(** [is_room_wanted p] is true if {!enlarge_shared} should be called soon. *)

val enlarge_shared : t -> unit
(** [enlarge_shared p] makes the index of a shared table larger. If many may insert, no other process may do so
    meanwhile, and all refresh before they do so again. It raises {!Limits.Over} if there is no more memory. *)

val go_on_apart : t -> full:(unit -> unit) -> unit
(** [go_on_apart p ~full] is called by a process that has been forked, before it inserts anything into a shared table.
    [full] is as for {!set_full}. *)

val set_full : t -> (unit -> unit) -> unit
(** [set_full p full]: this process calls [full] where a pair does not fit the index of a shared table. It makes room
    by {!enlarge_shared}, as it does by default, or raises. *)

(** {1 Reading} *)

val key : t -> int -> int
(** [key p i] is the packed pair with number [i], which must exist: it is not checked. *)

val unpack_left : int -> int
(** [unpack_left key] is the first number of a packed pair. *)

val unpack_right : int -> int
(** [unpack_right key] is the second number of a packed pair. *)

val left : t -> int -> int
(** [left p i] is the first number of the pair with number [i], which must exist (a bug otherwise). *)

val right : t -> int -> int
(** [right p i] is the second number of the pair with number [i], which must exist (a bug otherwise). *)

val bytes : t -> int
(** [bytes p] is about how much memory the table takes, in bytes. *)
