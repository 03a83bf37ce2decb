(** Formats of values that many documents contain: definitions of [specs/schema/common.schema.json]. *)

open Scc_exact
open Scc_json

val file : string
(** The name of that file, for {!Json_format.named}. *)

val rational : (Rat.t, Rat.t) Json_format.t
(** An exact rational ["p/q"]. *)

val vector : (Vec.t, Vec.t) Json_format.t
(** Three rationals. *)

val matrix : (Mat.t, unit) Json_format.t
(** Three rows of a matrix. *)

val quaternion : (Quaternion.t, unit) Json_format.t
(** Four integers as texts: w, x, y, z. *)

val digest : (string, string) Json_format.t
(** The digest of a model ({!Scc_loading.Origin.digest}). *)

val exit : (int, int) Json_format.t
(** The exit code of a command. *)

val texts : (string list, string list) Json_format.t
(** An array of strings. *)

val name : (string, string) Json_format.t
(** A string that is not empty. *)

val count : (int, int) Json_format.t
(** An integer from 0. *)

val head : string -> int -> ('o, unit) Json_format.members list
(** The members [format] and [version] with which a document begins. *)
