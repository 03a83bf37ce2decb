(** The report of [scc check] as JSON (see [specs/schema/check.schema.json]). *)

open Scc_base
open Scc_semantics
open Scc_verify
open Scc_session

(** What there is to report. *)
type t = {
  loaded : Loaded.t;
  verdicts : Verdict.outcome list;
  where : Scc_regions.Where.t list;  (** one for each, or none: for which values they hold *)
  report : Check.report;
  diagnostics : Diag.t list;
  exit : int;
  extra : (string * Json.t) list;  (** members that were asked for: [coverage], [measured] *)
  full : bool;  (** with all steps of the ways to states that were not explored *)
  cure : Verdict.outcome -> string option;  (** what may help with a verdict that met a bound *)
}

val kind : Verdict.t -> string
(** ["holds"], ["holds-up-to-bound"], ["violated"] or ["undecided"]. *)

val truncation : Verdict.truncation -> Json.t
(** A bound that was met. *)

val property :
  ?full:bool -> ?cure:(Verdict.outcome -> string option) -> ?where:Scc_regions.Where.t -> Semantics.t ->
  Verdict.outcome -> Json.t
(** A member of [properties]. Of the way to a state that was not explored it has the first and the last 100 steps,
    and all of them if [full]. *)

val finish : Scc_explain.Witness.t -> string
(** The word for where a run is taken to: ["state"], ["instant"], ["rests"], … *)

val argument : Scc_explain.Witness.argument -> Json.t

val invariants : Scc_calculus.Model.t -> Check.report -> (string * Json.t) list
(** The member [invariants], if any were looked for. *)

val explored : Scc_calculus.Model.t -> Check.stats -> Json.t

val document : source:(string -> Source.t option) -> t -> Json.t
