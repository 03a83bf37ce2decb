(** The check that a run, followed by the ordinary rules, proves its claims (rule Zones). Every state predicate
    of a claim is evaluated again, at all instants of the run that it concerns. Claims about all runs from a
    position rest on the zones alone. *)

open Scc_calculus
open Scc_semantics
open Scc_ctl
open Scc_exact
open Scc_symbolic
open Scc_explain

(** A run through the rules of a model whose parameters have values. *)
type t = { semantics : Semantics.t; values : Rat.t array; initial : State.t; steps : Witness.step array }

val state : t -> int -> State.t
(** [state r k] is the state after [k] steps. *)

val clock : t -> int -> Rat.t
(** [clock r k] is the time after [k] steps. *)

val extent : t -> int -> Timeline.extent
(** [extent r k] is the time that the run spends in the state after [k] steps: that of the next step, or one
    instant if it takes none. After the last step it is the time until an event could happen. *)

val arrived : t -> int -> Scc_property.Property.event -> bool
(** [arrived r k e] is true if step number [k], counted from 1, was the event [e]. *)

val claim : t -> Shown_run.claim -> bool
(** [claim r c] is true if the claim and all its parts are confirmed on the run. *)
