(** The ordinary rules at a point of the parameters, followed by brute force: what the zones are held against. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property

(** Where one is. *)
type visit = {
  state : State.t;
  arrived : int list;  (** the events that have just led here *)
  halted : bool;  (** within a passing of time, stopped for a weak split *)
}

type t = {
  visits : visit list;
  passings : (State.t * Rat.t option) list;  (** time passes from there, undisturbed, for so long *)
  complete : bool;  (** up to the horizon, nothing was left out *)
}

val explore :
  Semantics.t -> events:Property.event array -> horizon:Rat.t option -> instants:Rat.t list -> limit:int ->
  State.t -> t
(** From an initial state. Where bonds may be released at any time, time also stops at these instants. *)

val times : t -> Rat.t list
(** The instants of its states, where they know it. *)

val holds : Semantics.t -> events:Property.event array -> Property.prop -> visit -> Scc_ctl.Truth.t
val while_passing : Semantics.t -> Property.prop -> State.t * Rat.t option -> Scc_ctl.Truth.t list
(** What it is strictly after the start, piece by piece. *)
