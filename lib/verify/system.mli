(** Networks as a timed transition system, for the explorer. *)

open Scc_calculus
open Scc_semantics

type context = { model : Model.t; initial : State.t  (** as {!Network.initial} gives it *) }

include
  Scc_explore.Lts.S
  with type context := context
   and type state = State.t
   and type transition = Transition.t
   and type fault = Transition.fault
