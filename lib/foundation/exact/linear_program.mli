(** Small linear programs over rationals, solved exactly by the simplex method with Bland's rule, which ends. *)

val least : Rat.t array array -> Rat.t array -> cost:Rat.t array -> Rat.t option
(** [least rows right ~cost] is the least cost.x over all x >= 0 with rows.x = right; [None] if there is no such x.
    The right sides are not negative. The cost is bounded below (a bug otherwise). *)
