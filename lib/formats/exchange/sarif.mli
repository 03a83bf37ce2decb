(** Findings in the Static Analysis Results Interchange Format, SARIF 2.1.0: faults and warnings, and properties
    that are violated or undecided, for code review and editors.

    Every diagnostic code is a rule, and so are [violated] and [undecided]. Columns count Unicode code points, as
    elsewhere. A property's result stands at its [check]; the run that violates it is a code flow, whose steps
    all point to the [check], as events have no place in the text. An undecided property is of the kind [open],
    for which the format has no level. *)

open Scc_base
open Scc_calculus
open Scc_verify

val document :
  source:(string -> Source.t option) ->
  version:string ->
  exit:int ->
  ok:bool ->
  faults:string list ->
  diagnostics:Diag.t list ->
  properties:(Model.t * Verdict.outcome list) option ->
  Json.t
(** [ok]: the program did what it was asked to do; [faults]: of its own, by which something is missing.
    Diagnostics first, then properties, both in the order given. *)
