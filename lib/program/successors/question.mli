(** What is asked about the states of a model: one of the explorations that {!Scc_verify.Check.run} makes, and
    what it searches for. *)

open Scc_base
open Scc_property
open Scc_semantics
open Scc_state_space
open Scc_verify

(** A state formula that a property searches for. *)
type goal = { within : Scc_exact.Rat.t option; prop : Property.prop }

(** What a verdict is made of: goals by their numbers. *)
type plan =
  | Now of Scc_ctl.Truth.t  (** known in the initial state *)
  | Possibly of int  (** it holds iff some run meets the goal *)
  | Always of int  (** it holds iff no run meets the goal *)
  | All of plan list
  | Any of plan list
  | Other  (** of a property that searches alone do not decide: never a part of another one *)

type t = {
  loaded : Scc_session.Loaded.t;
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
(** All but {!Reduction.Order}, which depends on what has been found before. *)

val make :
  reductions:Reduction.kind list -> bits:int -> names:string list -> number:int -> Scc_session.Loaded.t ->
  (t, Diag.t list) result
(** For the properties of these names, all of them if there are none. SC0922 where there is no property of a
    name, or no exploration of this number. *)

val context : t -> Network_lts.context
(** A new one, without a memory of what was asked before. *)

val predicates : t -> Network_lts.context -> Scc_ctl.On_the_fly.predicate array
(** Of the goals. *)

val semantics : t -> Semantics.t
