(** Fenwick trees: counts of items in numbered boxes, and the box of the k-th item. Changes and searches take O(log
    n) steps for n boxes (Fenwick, A new data structure for cumulative frequency tables, 1994). *)

type t

val create : int -> t
(** [create n] is [n] empty boxes, numbered from 0. *)

val add : t -> int -> int -> unit
(** [add t box more] adds [more] items to the box, or removes them if [more] is negative. No count becomes
    negative: the caller ensures it. *)

val total : t -> int
(** [total t] is the number of items in all boxes. *)

val find : t -> int -> int * int
(** [find t k] is the box of the [k]-th item, counted from 0 through all boxes in order, and the index of the item
    within that box. [k] is from 0 to [total t - 1] (a bug otherwise). *)
