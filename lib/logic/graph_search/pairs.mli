(** Pairs of small integers, each numbered when it is first seen: 8 bytes for each, 4 where the numbers are less
    than 2{^16}, and 5 to 11 for the index. *)

type t

val create : in_files:bool -> t
(** With [in_files], tables may be made in files ({!Scc_data.Spill}): then no other process may have them. *)

val size : t -> int

val intern : t -> int -> int -> int
(** The number of a pair of numbers in [0, 2{^31}): numbers run from 0 in the order of first sight, so that a
    pair is new iff its number is the {!size} before. *)

val find : t -> int -> int -> int
(** -1 when it has not been seen. *)

(** {1 Many at once} *)

val pack : int -> int -> int
(** A pair as one number. *)

val intern_key : t -> int -> int
val find_key : t -> int -> int

val find_keys : t -> int array -> int array -> int -> unit
(** [find_keys p keys ids n] puts the numbers of the first [n] packed pairs into [ids], -1 where one has not been
    seen: of those that are far apart in memory, all are fetched at the same time. *)

(** {1 Reading} *)

val key : t -> int -> int
(** The packed pair of a number. *)

val unpack_left : int -> int
val unpack_right : int -> int
val left : t -> int -> int
val right : t -> int -> int

val bytes : t -> int
(** About how much memory it takes. *)
