(** The course of time after the last event of a quiescent run: turn follows on turn for ever (rule Turn). *)

open Scc_exact
open Scc_calculus
open Scc_semantics

val follow :
  Semantics.t -> start:Rat.t -> lasts:Rat.t -> State.t -> (start:Rat.t -> lasts:Rat.t -> State.t -> unit) -> unit
(** [follow semantics ~start ~lasts state piece] calls [piece] for each stretch of time in which no turn ends,
    in order. [piece] receives the time at which the stretch starts, its duration and the state there. The
    stretches take the time [lasts] together. *)
