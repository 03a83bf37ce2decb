(** The methods [successors], [step] and [replay]. *)

val successors : Models.store -> Read.params -> Reply.t
val step : Models.store -> Read.params -> Reply.t
val replay : Models.store -> Read.params -> Reply.t
