(** Traces: sequences of moves that can be observed. Two systems are compared by the subset construction, on the
    fly and breadth first over pairs of sets. So the first difference is a shortest one. *)

open Scc_exact

type view =
  | Every_action  (** silent actions are observed as others are; in a timed system so is time *)
  | Observable  (** silent actions are not observed *)

type step = Action of int | Time of Rat.t

type outcome =
  | Trace of { steps : step list; first : bool }
  (** A trace of the first system (of the second, if [first] is false) that the other certainly lacks. *)
  | Same  (** no difference: a proof of trace equivalence if all states are known *)
  | Too_large  (** the limits were reached *)
  | Unclear  (** no certain difference, but a trace led to states that are not fully known *)

type limits = {
  pairs : int;  (** the greatest number of pairs of sets *)
  members : int  (** the greatest number of members of all sets that are made, repeated ones included *)
}

val to_decide : limits
(** Limits for graphs that may be equivalent: up to a minute. *)

val to_explain : limits
(** Limits for graphs that are known to differ: a few seconds. *)

val compare : Effort.t -> limits -> view -> System.t -> System.position -> System.position -> outcome
(** [compare effort limits view m p q] compares the traces of the positions [p] and [q] of [m]. With
    [Every_action], the passing of time in a timed system is split where either side meets an instant. Raises
    {!Effort.Exhausted}. *)

val possible : view -> sure:bool -> System.t -> System.position -> step list -> bool
(** [possible view ~sure m p steps] is true if position [p] has the trace [steps]. Without [sure] it is also true
    if the trace may lead through states that are not fully known. *)

val formula : Modal_formula.store -> view -> step list -> Modal_formula.t option
(** [formula store view steps] is the formula that the trace is possible; [None] for more than {!Game.most_parts}
    steps. *)
