(** The report of [scc check] as JSON (see [specs/schema/check.schema.json]). *)

open Scc_base
open Scc_exact
open Scc_calculus
open Scc_property
open Scc_explain
open Scc_verify

(** What there is to report. *)
type t = {
  name : string option;
  digest : string;
  parameters : (string * Rat.t) list;
  model : Model.t;
  verdicts : (Property.check * Verdict.t) list;
  stats : Check.stats;
  slices : Check.slice list;
  zeno : Witness.t option;
  diagnostics : Diag.t list;
  exit : int;
  extra : (string * Json.t) list;  (** members that were asked for: [coverage], [measured] *)
}

val kind : Verdict.t -> string
(** ["holds"], ["holds-up-to-bound"], ["violated"] or ["undecided"]. *)

val truncation : Verdict.truncation -> Json.t
(** A bound that was met. *)

val document : source:(string -> Source.t option) -> t -> Json.t
