(** Formats of values in several answers: definitions of [specs/schema/oracle.schema.json]. *)

open Scc_exact
open Scc_json

val named : string -> ('w, 'r) Json_format.t -> ('w, 'r) Json_format.t
(** The format as a definition of this name. *)

val shape : (string, string) Json_format.t
(** The handle of a shape. *)

val model : (string, string) Json_format.t
(** The handle of a model. *)

val path : (int list, int list) Json_format.t
(** Choices from the initial state on. *)

val rules : (Scc_semantics.Rule.t list, string list) Json_format.t
(** The names of rules. *)

val quantity : (Rat.t, unit) Json_format.t
(** An exact number and the nearest float: [{"exact": "5/4", "float": 1.25}]. The float is [null] if it is not
    finite. *)

val released : (string, 'r) Json_format.t -> (string, unit) Json_format.t
(** The answer to the release of a handle. *)
