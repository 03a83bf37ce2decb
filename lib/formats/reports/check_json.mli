(** The report of [scc check] as JSON (see [specs/schema/check.schema.json]). *)

open Scc_base
open Scc_semantics
open Scc_verify
open Scc_json
open Scc_loading

(** The results of a check. *)
type t = {
  loaded : Loaded.t;
  verdicts : Verdict.outcome list;
  where : Scc_regions.Where.t list;  (** for each verdict, the values of parameters for which it holds; or none *)
  report : Check.report;
  diagnostics : Diag.t list;
  exit : int;
  extra : (string * Json.t) list;  (** optional members: [coverage], [measured] *)
  full : bool;  (** all steps of the ways to states that were not explored are included *)
  cure : Verdict.outcome -> string option;  (** what may help with a verdict that met a bound *)
}

val kind : Verdict.t -> string
(** The kind of a verdict: ["holds"], ["holds-up-to-bound"], ["violated"], ["measured"] or ["undecided"]. *)

val truncation_format : (Verdict.truncation, unit) Json_format.t
(** The format of a bound that stopped the exploration. *)

val truncation : Verdict.truncation -> Json.t
(** A bound that stopped the exploration. *)

val property :
  ?full:bool -> ?cure:(Verdict.outcome -> string option) -> ?where:Scc_regions.Where.t -> Semantics.t ->
  Verdict.outcome -> Json.t
(** A member of [properties]. The way to a state that was not explored has its first and last 100 steps, and all
    of them if [full]. [cure] is the text that may help with a verdict that met a bound. *)

val finish : Scc_explain.Witness.t -> string
(** The word for the end of a run of a witness: ["state"], ["instant"], ["rests"], … *)

val argument : Scc_explain.Witness.argument -> Json.t
(** The argument by which a witness proves a property, as an object. *)

val invariants : Scc_calculus.Model.t -> Check.report -> (string * Json.t) list
(** The member [invariants], if invariants were sought. *)

val explored : Scc_calculus.Model.t -> Check.stats -> Json.t
(** The member [explored]: the numbers of states and transitions, and whether the exploration is complete. *)

val document : source:(string -> Source.t option) -> t -> Json.t
(** The whole document. [source] returns the text of a file by its name, for lines and columns. *)
