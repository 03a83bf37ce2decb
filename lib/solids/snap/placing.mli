(** Vertices and planes that lie on each other exactly, near a guess. They are placed one after the other.
    Coordinates of an element that the earlier ones leave free are rounded to a grid; the others are solved
    for. *)

type element

type guess = int -> float array
(** The three coordinates of an element. *)

val place :
  Order.t -> grid:int -> guess -> keep:(int -> element -> bool) -> element array option
(** [place order ~grid guess ~keep] are the places by elements; free coordinates are multiples of 2^-grid.
    [None] if some element has no place or several, or if [keep] rejects it. *)

val vector : element -> Scc_exact.Vec.t
(** The point x of a vertex, or the n of a plane n . x = 1. *)
