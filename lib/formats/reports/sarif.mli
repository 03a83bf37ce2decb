(** Findings in the Static Analysis Results Interchange Format, SARIF 2.1.0, for code review and editors: faults
    and warnings, and properties that are violated or undecided.

    Every diagnostic code is a rule, and so are [violated] and [undecided]. Columns count Unicode code points,
    as elsewhere. The result of a property stands at its [check]. The run that violates it is a code flow, whose
    steps all point to the [check], since events have no place in the text. An undecided property is of the kind
    [open], for which the format has no level. *)

open Scc_base
open Scc_calculus
open Scc_verify
open Scc_json

val document :
  source:(string -> Source.t option) ->
  version:string ->
  exit:int ->
  ok:bool ->
  faults:string list ->
  diagnostics:Diag.t list ->
  properties:(Model.t * Verdict.outcome list) option ->
  Json.t
(** The whole document. [ok] is true if the program completed its task; [faults] are those of the program
    itself, by which results are missing. The results are the diagnostics and then the properties, both in the
    order given. *)
