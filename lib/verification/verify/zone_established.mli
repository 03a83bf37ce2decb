(** Whether a run that the ordinary rules have followed is what it is shown for (rule Zones): every state predicate
    that a claim is about is looked at again, at all instants of the run that it is about. That all runs from a
    position were looked at is known of the zones alone. *)

open Scc_calculus
open Scc_semantics
open Scc_evaluate
open Scc_ctl
open Scc_exact
open Scc_symbolic
open Scc_explain

(** A run through the rules of a model whose parameters have values. *)
type t = { semantics : Semantics.t; values : Rat.t array; initial : State.t; steps : Witness.step array }

val state : t -> int -> State.t
(** After so many steps. *)

val clock : t -> int -> Rat.t
(** How much time has passed then. *)

val trajectory : t -> int -> Trajectory.t
(** From the state after so many steps, until what comes next on the run, or until anything could. *)

val extent : t -> int -> Timeline.extent
val arrived : t -> int -> Scc_property.Property.event -> bool

val claim : t -> Shown_run.claim -> bool
