(** The method [model.where]: for which values of the parameters of a model, of which ranges are known, its checks
    hold. *)

val where : Evaluate.bounds -> Read.params -> Reply.t
