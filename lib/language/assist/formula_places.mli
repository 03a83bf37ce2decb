(** What can be written within a formula: after a dot, as an index, after [in], and as an argument. *)

val offers : Offers.place -> Pieces.item -> Offers.offer list option
(** [offers t i] is what the grammar and the kinds admit at the place, which is in the check [i]. An argument of an
    atom or event is a body or a channel as its form says ({!Forms}). It is [None] where any formula can begin. *)

val integers : Offers.place -> Pieces.item -> string list
(** The integer variables that the item declares before the place, by [for], [forall], [exists] or [count]. *)
