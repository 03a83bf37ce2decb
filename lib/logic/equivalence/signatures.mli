(** Hash-consed sets of numbers: {!Refine} distinguishes states by them. Each distinct set has a number until
    {!clear}. *)

type t

val create : unit -> t
(** [create ()] is an empty table of sets. *)

val clear : t -> unit
(** [clear t] removes all sets, in time proportional to their number. *)

(** {1 Writing a set}

    Numbers are added in any order, with repetitions. *)

val start : t -> unit
(** [start t] begins a new draft: an empty set. *)

val add : t -> int -> unit
(** [add t x] adds [x] to the draft. *)

val within : t -> except:int -> int -> bool
(** [within t ~except set] is true if all numbers of the draft, except the number [except], are members of the set
    with number [set]. *)

val finish : t -> int
(** [finish t] is the number of the set in the draft. Sets are numbered from 0 in the order of first appearance. *)

val count : t -> int
(** [count t] is the number of distinct sets. *)
