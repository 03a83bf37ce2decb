(** What the documents say of the model that they are about. *)

open Scc_session

val parameters : Origin.t -> Json.t

val settings : Origin.t -> Json.t
(** An object of strings. *)

val members : Origin.t -> (string * Json.t) list
(** [model], [digest], [parameters] and [settings]. *)
