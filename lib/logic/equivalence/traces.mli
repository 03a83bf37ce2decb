(** Traces: what can be observed, one move after the other. Sets of states are made as they are needed (the subset
    construction), in pairs, breadth first; so the first difference is a shortest one. *)

open Scc_exact

type view =
  | Every_action  (** silent actions are seen like others; in a timed system time is seen as well *)
  | Observable  (** silent actions are not seen *)

type step = Action of int | Time of Rat.t

type outcome =
  | Trace of { steps : step list; first : bool }
  (** a trace of the first system (of the second, when [first] is false) that the other certainly lacks *)
  | Same  (** no difference: a proof of trace equivalence when everything is known *)
  | Too_large  (** more than so many pairs of sets, or sets with so many members altogether *)
  | Unclear  (** no certain difference; a trace led to states that are not known *)

type limits = { pairs : int; members : int }

val to_decide : limits
(** Up to a minute. *)

val to_explain : limits
(** A few seconds: of graphs that are known to differ. *)

val compare : Effort.t -> limits -> view -> System.t -> System.position -> System.position -> outcome
(** [view] [Every_action] on a timed system splits the passing of time where either side meets an instant.
    Raises {!Effort.Exhausted}. *)

val possible : view -> sure:bool -> System.t -> System.position -> step list -> bool
(** Whether the system has the trace: for certain, or with [sure] false perhaps, since it may lead through unknown
    states. *)

val formula : Formula.store -> view -> step list -> Formula.t option
(** That the trace is possible; [None] for traces longer than {!Game.most_parts}. *)
