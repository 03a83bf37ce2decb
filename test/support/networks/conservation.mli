(** What discrete transitions conserve (rule WellFormed), exactly. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

(** Of all processes that are not fixed, summed over their parts. *)
type sums = {
  momentum : Vec.t;
  angular : Vec.t;  (** momentum, about the origin *)
  energy : Rat.t;  (** twice the kinetic *)
}

val sums : Model.t -> State.t -> sums
val of_process : Model.t -> State.process -> sums

val fault : Model.t -> State.t -> Transition.t -> string option
(** What a transition of a state breaks: momentum for bindings, bounces and splits in which nothing fixed
    takes part, and in a rigid model angular momentum; energy for bounces and splits; a binding must not gain
    any. A transition that steers or rounds is not looked at: laws of motion and rounding conserve nothing. *)
