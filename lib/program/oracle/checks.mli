(** The method [model.check]: verdicts for the checks of a model, over all values of parameters of which ranges
    are known and all instants of splits where it leaves them open; and for which values they hold. *)

val check : Evaluate.bounds -> Models.store -> Read.params -> Reply.t
