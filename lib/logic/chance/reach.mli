(** The least and the greatest probability of "stay until goal" over all schedulers (Baier and Katoen, section
    10.6). The graph tells where it is 0 and where 1 ({!Qualitative}). For the greatest one, end components of what
    is left are merged: a scheduler can go to any state of one, and gains nothing by staying. For the least one
    none are left: a scheduler that stayed would have probability 0. *)

val solve : Qualitative.t -> Equations.direction -> Effort.t -> asked:Solution.asked -> Solution.t
(** Values are [Exact] or [Within]. *)
