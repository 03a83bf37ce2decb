(** The least and the greatest probability of "stay until goal" over all schedulers (Baier and Katoen, section
    10.6).

    The graph decides the states in which it is 0 or 1 ({!Qualitative}). For the greatest one, end components of
    the other states are merged: a scheduler can go to any state of one, and gains nothing by staying. For the
    least one no end component is left: a scheduler that stayed would have probability 0. *)

val problem : Qualitative.t -> Equations.direction -> Solution.problem
(** [problem q direction] is the problem that {!solve} solves. *)

val solve : Qualitative.t -> Equations.direction -> Effort.t -> asked:Solution.asked -> Solution.t
(** [solve q direction effort ~asked] is the least or the greatest probabilities of the states [asked]. Values are
    [Exact] or [Within]. *)
