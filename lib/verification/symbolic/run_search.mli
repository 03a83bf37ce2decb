(** The forward search for runs over zones that {!Branching} has proved to exist, from states from which there
    is one. *)

open Scc_exact
open Scc_polyhedra

(** Runs that take the same steps: to a node, or to an instant in one of its stretches. *)
type walk = {
  way : Concrete.way;
  node : int;
  inside : (int * Linear.t) option;  (** which of its stretches, and the time since the node *)
}

(** The end of a run. Steps are counted from 0, including those that wait no time for a weak split. *)
type finish =
  | There  (** the run leads to the end of the walk *)
  | Rests  (** nothing happens any more, and time passes for ever *)
  | Passes of Rat.t  (** the next event is after this bound of the model time *)
  | Repeats of int  (** the steps from this one on bring it back to its state, up to a displacement of the
                        whole *)
  | Goes_on of int
  (** The run is in a state of the zone in which it was before this step. Some run goes on from there. No run
      was found that comes back to a state. *)

val dimension : walk -> int
(** The number of variables of the forms of a walk. *)

val steps : walk -> int
(** The number of steps of a walk. *)

val among : Timed_sets.sets -> walk -> walk list
(** [among set walk] are the parts of the walk that end in a set of states. *)

val right_after : Timed_sets.model -> Timed_sets.sets -> walk -> walk list
(** [right_after m set walk] are the parts of the walk within the next stretch, such that all states from there
    on are in a set of states. *)

val some_run :
  Timed_sets.model -> Branching.search -> win:Timed_sets.sets -> high:Rat.t option -> walk ->
  (walk * finish) option
(** [some_run m search ~win ~high walk] is a run for the search that continues the walk. The set [win] has the
    states from which there is one. A run that goes on for ever need not be followed beyond the time [high].
    The search is breadth-first; runs in which time goes on are preferred. [None] if none was found among the
    first few thousand. *)
