(** One start of many, as the ordinary model that it is. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_explain

val named : Model.t -> Rat.t array -> (string * Rat.t) list
(** Values of the parameters, with their names. *)

val run :
  Joint_check.options -> Semantics.t -> Uncertain.t -> declared:State.t -> Property.check -> Rat.t array ->
  Witness.t option
(** What the ordinary exploration of one start shows of a check that is violated for it: a run of that start, with
    its reasons. [None] where bonds may be released at any time, where there are no ranges, and where it decides
    nothing within 20 000 states. {!Scc_graph_search.Limits.Over} where the work is to end before. It is a bug if
    the check holds for that start. *)
