(** How time goes on after the last event of a run that is quiescent: turn follows on turn for ever (rule Turn). *)

open Scc_exact
open Scc_calculus
open Scc_semantics

val follow :
  Semantics.t -> start:Rat.t -> lasts:Rat.t -> State.t -> (start:Rat.t -> lasts:Rat.t -> State.t -> unit) -> unit
(** [follow semantics ~start ~lasts state piece] calls [piece] for each stretch of time in which no turn ends, one
    after the other, with the time at which it starts and the state there. *)
