(** Orders in which the unknowns of a sparse system are eliminated with few new entries: minimum degree, on
    quotient graphs (Amestoy, Davis and Duff, "An approximate minimum degree ordering algorithm", 1996). *)

type t = {
  order : int array;  (** the unknowns, the first to be eliminated first *)
  steps : int;
  (** The number of products that the elimination takes at most, one for each two entries that meet, and what it
      took to find the order, in the same unit. *)
}

val compute : neighbours:int array array -> most:int -> interrupted:(unit -> bool) -> t option
(** [compute ~neighbours ~most ~interrupted] is an order for the unknowns 0, 1, ... . [neighbours.(i)] is the other
    unknowns that have an entry in row [i] or column [i], each once, so the relation is symmetric. It is [None] if
    that is more than [most] steps, or if it is interrupted. The result is the same in each run. *)
