(** Small linear programs over rationals, exactly: the simplex method with Bland's rule, which ends. *)

val least : Rat.t array array -> Rat.t array -> cost:Rat.t array -> Rat.t option
(** [least rows right ~cost] is the least cost.x over all x >= 0 with rows.x = right, for right sides that are not
    negative and a cost that is bounded below; [None] if there is no such x. *)
