(** Truth values at the offsets strictly inside a flow: alternately on an open interval and at the cut after it.
    They are stored as one byte each, since millions of them may be kept. *)

open Scc_exact

type t = private {
  cuts : Algebraic.t array;  (** increasing, positive *)
  cells : Bytes.t;
  (** Cell 2i is the open interval before cut i, or up to the end for the last cell. Cell 2i + 1 is the instant of
      cut i. A cell is ['\001'] if it is true, and ['\000'] if not. *)
}

val constant : bool -> t
(** [constant v] is [v] at all offsets. *)

val is_constant : t -> bool
(** [is_constant p] is true if [p] has no cuts. *)

val equal : t -> t -> bool
(** [equal p q] is true if cuts and cells are equal. *)

val not_ : t -> t
(** [not_ p] is true where [p] is false. *)

val map2 : (bool -> bool -> bool) -> t -> t -> t
(** [map2 f p q] is [f] of the values of [p] and [q] at each offset, without cuts at which nothing changes. *)

val of_timeline : ('a -> bool) -> 'a Timeline.t -> t
(** [of_timeline test t] is [test] of the values of [t] after its start. *)

val build : limit:Algebraic.t option -> Algebraic.t list -> (Algebraic.t -> bool) -> t
(** [build ~limit cuts f] is [f], which changes at most at the cuts. Cuts that are not positive or not below the
    limit are ignored, and their order does not matter. [f] is called at cuts, and at a rational inside each
    interval. *)

val of_pieces : bool -> (Algebraic.t * bool * bool) list -> t
(** [of_pieces first pieces] has the value [first] before the first cut. [pieces] are increasing cuts, each with
    the values at it and after it. *)

(** {1 Cells} *)

val cells : t -> int
(** [cells p] is the number of cells: twice the number of cuts, plus 1. *)

val holds : t -> int -> bool
(** [holds p i] is the value of cell [i], from 0. *)

val find : t -> Algebraic.t -> int
(** [find p offset] is the cell of a positive offset. *)

val at : t -> Algebraic.t -> bool
(** [at p offset] is the value at a positive offset. *)

val low : t -> int -> Algebraic.t
(** [low p i] is the offset at which cell [i] begins: 0 for the first. *)

val high : t -> int -> Algebraic.t option
(** [high p i] is the cut at which an open cell [i] ends; [None] for the last cell. *)

val is_point : int -> bool
(** [is_point i] is true if cell [i] is the instant of a cut, and false if it is an open interval. *)

val inside : Algebraic.t -> Algebraic.t option -> Rat.t
(** [inside low high] is a rational strictly between two offsets; [None] is infinity. *)

(** {1 Two at once} *)

(** Two values at each offset, with common cuts. *)
type pair = { left : t; right : t }

val pair : t -> t -> pair
(** [pair p q] is [p] and [q], both cut at the cuts of either. *)
