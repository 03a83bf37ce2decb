(** Random models with chance and ranges, of one check each. *)

val pick : Random.State.t -> 'a list -> 'a
(** One element of the list. *)

val chance : Random.State.t -> int -> bool
(** [chance random percent] is true with this probability. *)

val any_time : string
(** The line of models in which bonds may break at any time. *)

val model : Random.State.t -> string
(** The text of a model. Its check is named [c]. *)
