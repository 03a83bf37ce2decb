(** The methods [successors], [step] and [replay]. *)

val successors : Models.store Method.t
(** The method [successors]: the transitions of the state at the end of a path. *)

val step : Models.store Method.t
(** The method [step]: one transition, by its number or the text of its label. *)

val replay : Models.store Method.t
(** The method [replay]: a whole run, by its choices or by a policy. *)
