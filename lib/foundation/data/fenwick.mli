(** Counts of things in boxes that are numbered, which change, and the question in which box the k-th thing is:
    both take O(log n) steps for n boxes (Fenwick, A new data structure for cumulative frequency tables, 1994). *)

type t

val create : int -> t
(** So many boxes, from number 0 on, with nothing in them. *)

val add : t -> int -> int -> unit
(** [add t box more]: so many more in this box, or less, where it is negative; no box has less than none. *)

val total : t -> int
(** In all boxes. *)

val find : t -> int -> int * int
(** [find t k], for [k] from 0 to [total t - 1] (a bug otherwise): the box of the k-th thing, counted from 0
    through all boxes in order, and which one it is of that box. *)
