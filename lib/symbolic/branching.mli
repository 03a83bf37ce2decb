(** Formulas of timed CTL on a graph of zones: for which values of the parameters they hold (rules Run and
    Instants). Sets of states are computed backwards over the edges, exactly: what is true strictly between two
    events is a set of states of the trajectory, over one variable more. *)

open Scc_polyhedra
open Scc_property

val holds : Instant.context -> Atoms.context -> Zone_graph.t -> Property.temporal -> (Union.t, string) result
(** Of a graph in which all is known up to the latest bound of the formula ({!Plan.horizon}): the values for which
    it holds at the start. The error says why it is not known: a number that is not linear, a bound of time within
    another operator, the operator X, or sets that do not come to rest. *)
