(** The union of convex pieces into larger convex pieces, as in Hertel and Mehlhorn (1983). *)

val merged : Grid.t -> int array list -> int array list
(** Convex pieces, after all possible unions. The pieces are given by their corners, counter-clockwise, and are
    adjacent along whole edges. Two pieces with a common edge and a convex union become one, until there are no
    such two. *)
