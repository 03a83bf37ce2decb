(** The model that a document is about. *)

open Scc_exact
open Scc_json
open Scc_loading

val fields : (Origin.t, unit) Json_format.members
(** The format of the members [model], [digest], [parameters] and [settings]. *)

val identity : (Origin.t, unit) Json_format.members
(** The format of [digest], [parameters] and [settings] alone. *)

val parameters_format : ((string * Rat.t) list, (string * Rat.t) list) Json_format.t
(** The format of parameters with their values. *)

val settings_format : ((string * string) list, (string * string) list) Json_format.t
(** The format of settings, as an object of texts. *)

val parameters : Origin.t -> Json.t
(** An object of the parameters with their values, as by {!Scc_json.Json.rat}. *)

val settings : Origin.t -> Json.t
(** An object of the settings, as strings. *)
