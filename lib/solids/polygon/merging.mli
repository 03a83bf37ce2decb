(** Convex pieces made one where they stay convex, as in Hertel and Mehlhorn (1983). *)

val merged : Grid.t -> int array list -> int array list
(** Pieces by their corners, counter-clockwise, side by side at whole edges: of two that have an edge in common and
    whose union is convex one is made, until there are no such two. *)
