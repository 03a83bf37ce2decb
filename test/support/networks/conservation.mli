(** What discrete transitions conserve (rule WellFormed), exactly. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

val momentum : Model.t -> State.t -> Vec.t
(** Of all processes that are not fixed. *)

val energy : Model.t -> State.t -> Rat.t
(** Twice the kinetic energy of the same. *)

val fault : Model.t -> State.t -> Transition.t -> string option
(** What a transition of a state breaks: momentum for bindings, bounces and splits in which nothing fixed
    takes part, energy for bounces and splits; a binding must not gain any. A transition that steers is
    not looked at: laws of motion conserve nothing. *)
