(** The ordinary model of one start of many. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_explain
open Scc_verify

val named : Model.t -> Rat.t array -> (string * Rat.t) list
(** The values of the parameters, with their names. *)

val run :
  Setup.t -> Semantics.t -> Uncertain.t -> declared:State.t -> Property.check -> Rat.t array ->
  Witness.t option
(** The run of one start, with its reasons, for a check that is violated for it. The ordinary exploration of that
    start finds it. [None] if bonds may be released at any time, if there are no ranges, or if 20 000 states decide
    nothing. It raises {!Scc_graph_search.Limits.Over} if the work has to end before. It is a bug if the check
    holds for that start. *)
