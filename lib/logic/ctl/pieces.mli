(** What holds at the offsets strictly inside a flow: alternately on an open interval and at the cut after it.
    A yes or no only, packed, since millions of these may be kept. *)

open Scc_exact

type t = private {
  cuts : Algebraic.t array;  (** increasing, positive *)
  cells : Bytes.t;
  (** cell 2i is the open interval before cut i (the last one: up to the end), cell 2i + 1 the instant of cut i;
      ['\001'] where it holds, ['\000'] elsewhere *)
}

val constant : bool -> t
val is_constant : t -> bool
val equal : t -> t -> bool
val not_ : t -> t
val map2 : (bool -> bool -> bool) -> t -> t -> t

val of_timeline : ('a -> bool) -> 'a Timeline.t -> t
(** Without the start. *)

val build : limit:Algebraic.t option -> Algebraic.t list -> (Algebraic.t -> bool) -> t
(** [build ~limit cuts f] is [f], which changes at most at the cuts; those that are not positive or not below the
    limit do not matter, nor does their order. [f] is asked at cuts, and at a rational inside each interval. *)

val of_pieces : bool -> (Algebraic.t * bool * bool) list -> t
(** From the value before the first cut, and increasing cuts with the values at and after each. *)

(** {1 Cells} *)

val cells : t -> int
val holds : t -> int -> bool

val find : t -> Algebraic.t -> int
(** The cell of a positive offset. *)

val at : t -> Algebraic.t -> bool
(** Whether it holds at a positive offset. *)

val low : t -> int -> Algebraic.t
(** Where a cell begins (0 for the first). *)

val high : t -> int -> Algebraic.t option
(** The cut at which an open cell ends; [None]: it is the last one. *)

val is_point : int -> bool

val inside : Algebraic.t -> Algebraic.t option -> Rat.t
(** A rational strictly between two offsets; [None] is infinity. *)

(** {1 Two at once} *)

(** Two conditions with common cuts. *)
type pair = { left : t; right : t }

val pair : t -> t -> pair
