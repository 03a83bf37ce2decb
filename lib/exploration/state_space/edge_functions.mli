(** The probabilities of edges as functions of the parameter of which the model has a number in its weights and
    chances (rule Parametric). *)

open Scc_base
open Scc_calculus

exception Ambiguous
(** Two functions that differ have one value at the value of the parameter that was explored. Another value of it
    has to be explored. *)

exception Refused of Diag.t
(** A probability is 0, or not defined, for some value within the range: states and transitions would not be the
    same. *)

val make :
  Network_lts.context -> Ranges.range -> tuple:(int -> int array) -> Scc_ctl.Timed_graph.t ->
  Scc_ctl.Sensitivity.parameter
(** [make c range ~tuple graph] is the functions of all edges of the known nodes of [graph], a graph of [c] without
    joint draws. [tuple s] is the state of node [s]. May raise {!Ambiguous} or {!Refused}. *)
