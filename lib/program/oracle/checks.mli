(** The method [model.check]: verdicts for the checks of a model. They hold for all values of parameters with
    known ranges, and for all instants of splits that the model leaves open. On request, the answer has the
    values for which they hold. *)

val check : (Evaluate.bounds * Models.store) Method.t
(** The method [model.check]. A refused model ends it with [Model_refused]. *)
