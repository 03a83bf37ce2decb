(** Arrays of small integers, four bytes each, outside of the heap of the garbage collector: graphs of 10^7 edges
    are stored in them. Indices of arrays are checked ([Invalid_argument]), except by {!unsafe_get}. *)

type t

val max_value : int
(** 2^31 - 1: the greatest value. Values are from -2^31 to this. *)

val make : int -> int -> t
(** [make n x] is an array of length [n] in which each element is [x]. *)

val length : t -> int
(** [length a] is the number of elements. *)

val get : t -> int -> int
(** [get a i] is element [i], from 0. *)

val set : t -> int -> int -> unit
(** [set a i x] replaces element [i] by [x], of which it keeps the lowest 32 bits. *)

val unsafe_get : t -> int -> int
(** [unsafe_get a i] is {!get} without a check of the index: for the innermost loops, over indices that are in
    range by construction. *)

val prefix : t -> int -> t
(** [prefix a n] is the first [n] elements. It shares memory with [a]. *)

(** {1 Growing}

    A buffer is one array, which doubles when it is full. It is quicker than {!Int_vector}, which takes less memory
    and never moves its elements. *)

type buffer

val buffer : unit -> buffer
(** [buffer ()] is a new empty buffer. *)

val size : buffer -> int
(** [size b] is the number of elements. *)

val nth : buffer -> int -> int
(** [nth b i] is element [i], from 0 to [size b - 1]; [Invalid_argument] for any other index. *)

val put : buffer -> int -> int -> unit
(** [put b i x] replaces element [i], from 0 to [size b - 1]; [Invalid_argument] for any other index. *)

val push : buffer -> int -> unit
(** [push b x] appends [x], in amortised constant time. *)

val pop : buffer -> int
(** [pop b] is the last element, which it removes; [Invalid_argument] if the buffer is empty. *)

val clear : buffer -> unit
(** [clear b] removes all elements, and keeps the memory. *)

val contents : buffer -> t
(** [contents b] is a copy of all elements. *)
