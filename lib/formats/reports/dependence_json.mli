(** Answers that depend on a parameter, as JSON (rule Parametric). *)

open Scc_verify
open Scc_json

val format : (Verdict.dependence, unit) Json_format.t
(** An answer as a function of the parameter, and where a claim holds. *)
