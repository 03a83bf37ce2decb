(** Formulas of timed CTL on a graph of zones: the values of the parameters for which they hold (rules Run,
    Instants, Next and Until). Sets of states are computed backwards over the edges, exactly. States strictly
    between two events are states of the trajectory, over one more variable. *)

open Scc_polyhedra
open Scc_property
open Scc_state_sets

type t
(** The sets of states of a formula and its parts. *)

type answer = {
  decided : t;
  holds : Union.t;  (** the values for which the formula holds at the start *)
  fails : Union.t;  (** those for which it does not; all others depend on states that are not expanded *)
}

val answer : Instant.context -> Atoms.context -> Zone_graph.t -> Property.temporal -> (answer, string) result
(** [answer c atoms graph formula] says for which values the formula holds. If a bound of time has ended the graph,
    the formula looks no further ({!Scc_property.Plan.reach}). The error is the reason why it is not known:
    a number that is not linear, a bound of time within another operator, a probability, or an
    iteration that does not converge. *)

(** {1 What decides a formula}

    For a formula that was decided, and its parts. Bounds of time count from the start, for the [outermost]
    operators. *)

val model : t -> Timed_sets.model
(** The states of the graph. *)

val truth : t -> outermost:bool -> Property.temporal -> holds:bool -> Timed_sets.sets
(** [truth t ~outermost f ~holds] are the states where [f] surely holds, or those where it surely does not. Of
    states that depend on nodes that are not expanded, neither is sure. *)

(** The runs that decide an operator of time. *)
type search =
  | Comes of { before : Timed_sets.sets; goal : Timed_sets.sets }
  (** a run that comes to the goal, with states of [before] until then *)
  | Stays of { states : Timed_sets.sets; over : Timed_sets.sets }
  (** a run with such states alone, for ever, or until the horizon; all runs from [over] have such states alone *)
  | Leads of Timed_sets.sets  (** a run whose next event leads to these states, however late it is *)

type quantified = {
  holds_if_any : bool;  (** if true, the operator holds where one of these runs exists; if false, it fails
                            there *)
  searches : (search * Timed_sets.sets) list;  (** with the states from which there is such a run *)
}

val quantified : t -> outermost:bool -> Property.temporal -> quantified option
(** The searches that decide a formula whose outermost operator is one of time; [None] for other formulas. *)

val in_bound : Property.bound -> Property.temporal -> Property.temporal
(** [in_bound b f] says that [f] holds and that the time since the start is within the bound, which is that of
    an outermost operator. *)
