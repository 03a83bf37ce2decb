(** The report of [scc check] as JSON (see [specs/schema/check.schema.json]). *)

open Scc_base
open Scc_semantics
open Scc_verify
open Scc_json
open Scc_loading
open Scc_runs

(** The results of a check. *)
type t = {
  loaded : Loaded.t;
  verdicts : Verdict.outcome list;
  where : Scc_regions.Where.t list;  (** for each verdict, the values of parameters for which it holds; or none *)
  report : Check.report;
  diagnostics : Diag.t list;
  exit : int;
  coverage : (Explored.t * Coverage.t) option;
  measured : Measured_json.t option;
  full : bool;  (** all steps of the ways to states that were not explored are included *)
  cure : Verdict.outcome -> string option;  (** what may help with a verdict that met a bound *)
}

val values : Verdict.t -> (Scc_property.Property.side * Scc_ctl.Eval.measured) list option
(** The answer of a verdict that is a number. *)

val values_format : ((Scc_property.Property.side * Scc_ctl.Eval.measured) list, unit list) Json_format.t
(** The format of {!values}. *)

val reasons : Verdict.t -> Verdict.reason list
(** Why a verdict is undecided, or why a number is not better known. *)

(** A verdict with what its report depends on. *)
type judged

val kind : Verdict.t -> string
(** The kind of a verdict: ["holds"], ["holds-up-to-bound"], ["violated"], ["measured"] or ["undecided"]. *)

val kind_format : (string, string) Json_format.t
(** One of the texts of {!kind}. *)

val judged :
  ?full:bool -> ?cure:(Verdict.outcome -> string option) -> ?where:Scc_regions.Where.t -> Semantics.t ->
  Verdict.outcome -> judged
(** A verdict as it is told. The way to a state that was not explored has its first and last 100 steps, and all
    of them if [full]. [cure] is the text that may help with a verdict that met a bound. *)

val property_format : (judged, unit) Json_format.t
(** The format of a member of [properties]. *)

val format : (Diag_json.source * t, unit) Json_format.t
(** The format of {!document}. *)

val invariants_member : (Scc_calculus.Model.t * Check.report, unit) Json_format.members
(** The format of the member [invariants], which is there if invariants were sought. *)

val document : source:Diag_json.source -> t -> Json.t
(** The whole document. [source] returns the text of a file by its name, for lines and columns. *)
