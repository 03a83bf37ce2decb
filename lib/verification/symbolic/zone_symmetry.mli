(** Rule Symmetry for zones: of zones that differ by which of some interchangeable leaves is where, one is
    followed. No order of leaves is the same in all states of a zone; it is enough to put them in an order that
    depends on the zone as a whole, by what no renaming changes as far as possible. *)

val image : classes:int list list -> Zone.t -> int array option
(** For each leaf the one whose name it gets, so that the members of each class come in order, and what is left of
    them first (rule Absorb); [None] where they do. *)
