(** What an exploration came to, as JSON ([specs/schema/check.schema.json]). *)

open Scc_calculus
open Scc_verify
open Scc_json

val truncation : (Verdict.truncation, unit) Json_format.t
(** The format of a bound that stopped an exploration. *)

val left_out : (Verdict.truncation, unit) Json_format.t
(** The format of a bound by which something is not shown. *)

val format : (Model.t * Stats.t, unit) Json_format.t
(** The format of the numbers of states and transitions. It says as well if the exploration is complete. *)
