(** The model that a document is about. *)

open Scc_json
open Scc_loading

val parameters : Origin.t -> Json.t
(** An object of the parameters with their values, as by {!Json.rat}. *)

val settings : Origin.t -> Json.t
(** An object of the settings, as strings. *)

val members : Origin.t -> (string * Json.t) list
(** The members [model], [digest], [parameters] and [settings]. *)
