(** Formats of values that many documents contain: definitions of [specs/schema/common.schema.json]. *)

open Scc_exact
open Scc_json

val file : string
(** The name of that file, for {!Scc_json.Json_format.named}. *)

val rational : (Rat.t, Rat.t) Json_format.t
(** An exact rational ["p/q"]. *)

val vector : (Vec.t, Vec.t) Json_format.t
(** Three rationals. *)

val matrix : (Mat.t, unit) Json_format.t
(** Three rows of a matrix. *)

val quaternion : (Quaternion.t, unit) Json_format.t
(** Four integers as texts: w, x, y, z. *)

val seed : (int64, string) Json_format.t
(** The seed of random choices. *)

val digest : (string, string) Json_format.t
(** The digest of a model ({!Scc_loading.Origin.val-digest}). *)

val bytes : (string, string) Json_format.t
(** Bytes, one or more, as pairs of hexadecimal digits, which are what is read. *)

val exit : (int, int) Json_format.t
(** The exit code of a command. *)

val code : (string, string) Json_format.t
(** The code of a diagnostic. *)

val numbered : string -> (string, string) Json_format.t
(** [numbered letter] is texts such as ["p1"]: the letter and a number from 1. *)

val texts : (string list, string list) Json_format.t
(** An array of strings. *)

val from_one : (int, int) Json_format.t
(** An integer from 1. *)

val semantics : unit -> ('o, unit) Json_format.members
(** The member [semantics]: the version of the rule book. *)

val head : string -> int -> ('o, unit) Json_format.members list
(** The members [format] and [version] with which a document begins. *)
