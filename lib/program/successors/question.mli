(** A question about the states of a model: one of the explorations of {!Scc_verify.Check.run}, with the goals
    of its search. *)

open Scc_base
open Scc_property
open Scc_semantics
open Scc_state_space
open Scc_verify

(** A state formula that a property searches for, and the time up to which it counts. That is the bound of the
    property, or a lesser time after which the formula is known to be false. *)
type goal = { within : Scc_exact.Rat.t option; prop : Property.prop }

(** How a verdict follows from goals, which are given by their numbers. *)
type plan =
  | Now of Scc_ctl.Truth.t  (** known in the initial state *)
  | Possibly of int  (** it holds iff some run meets the goal *)
  | Always of int  (** it holds iff no run meets the goal *)
  | All of plan list
  | Any of plan list
  | Other  (** a property that searches alone do not decide; never a part of another plan *)

(** An exploration with its goals. *)
type t = {
  loaded : Scc_loading.Loaded.t;
  initial : Scc_calculus.State.t;  (** of the whole network *)
  reductions : Reduction.kind list;
  bits : int;
  number : int;  (** of the exploration, from 1 *)
  count : int;  (** of explorations *)
  exploration : Check.exploration;
  plans : (Property.check * plan) list;
  goals : goal array;
}

val reductions : Reduction.kind list
(** All reductions except {!Reduction.Order}, which depends on the states found before. *)

val make :
  reductions:Reduction.kind list -> bits:int -> names:string list -> number:int -> Scc_loading.Loaded.t ->
  (t, Diag.t list) result
(** The question of the properties with these names, or of all if there are none. An unknown property or
    exploration is SC0922. *)

val is_premise : t -> Property.check -> bool
(** [is_premise q check] is true if the check is none of the model, but has to come true for one of them to say
    anything. *)

val horizon : t -> Scc_exact.Rat.t option
(** The time after which no property depends on states: no state that is reached later is expanded. *)

val context : t -> Network_lts.context
(** A new transition system of the exploration, with empty caches. *)

val predicates : t -> Network_lts.context -> Scc_ctl.On_the_fly.predicate array
(** The predicates of the goals. *)

val semantics : t -> Semantics.t
(** The semantics of the exploration. *)
