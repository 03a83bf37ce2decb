(** Vertices and planes that lie on each other exactly, near a guess. They are placed one after the other: what the
    earlier ones leave open of an element is rounded to a grid, and the rest is solved for. *)

type element

type guess = int -> float array
(** The three coordinates of an element. *)

val place :
  Order.t -> grid:int -> guess -> keep:(int -> element -> bool) -> element array option
(** By elements; free coordinates are multiples of 2^-grid. [None] when some element has no place or more than one,
    or [keep] does not want it. *)

val vector : element -> Scc_exact.Vec.t
(** The vertex x, or the n of the plane n . x = 1. *)
