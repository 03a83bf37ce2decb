(** Formulas of timed CTL on a graph of zones: for which values of the parameters they hold (rules Run, Instants,
    Next and Until). Sets of states are computed backwards over the edges, exactly: what is true strictly between
    two events is a set of states of the trajectory, over one variable more. *)

open Scc_polyhedra
open Scc_property

type t
(** What was found of a formula and its parts. *)

val holds : Instant.context -> Atoms.context -> Zone_graph.t -> Property.temporal -> (t * Union.t, string) result
(** Of a graph in which all is known up to the latest bound of the formula ({!Plan.horizon}): the values for which
    it holds at the start. The error says why it is not known: a number that is not linear, a bound of time within
    another operator, a probability, or sets that do not come to rest. *)

(** {1 What decides a formula}

    Of a formula that was decided, and of its parts. Bounds of time count from the start, for the [outermost]
    operators. *)

val model : t -> State_sets.model

val truth : t -> outermost:bool -> Property.temporal -> holds:bool -> State_sets.sets
(** Where it holds, or where it does not. *)

(** Of an operator of time: some run. *)
type search =
  | Comes of { before : State_sets.sets; goal : State_sets.sets }
  (** that comes to the goal, with states of [before] until then *)
  | Stays of State_sets.sets  (** with such states alone, for ever, or until the horizon *)
  | Leads of State_sets.sets  (** of which the next event leads to these states, however late it is *)

type quantified = {
  holds_if_any : bool;  (** the operator holds where there is any of these runs; else it does not hold there *)
  searches : (search * State_sets.sets) list;  (** with the states from which there is one *)
}

val quantified : t -> outermost:bool -> Property.temporal -> quantified option

val in_bound : Property.bound -> Property.temporal -> Property.temporal
(** That it is so and that the time since the start is within the bound, which is one of an outermost operator. *)
