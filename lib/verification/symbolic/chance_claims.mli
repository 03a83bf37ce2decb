(** The predicates of an until, or of a mean, on zones and on what passes by between two events (rules Until and
    Intervals). *)

open Scc_exact
open Scc_polyhedra
open Scc_property
open Scc_state_sets

(** What is wanted of the runs with "f until g". A mean has f true, and no bound of time. *)
type wanted =
  | Chance  (** the probability of the until *)
  | Time  (** the mean time until g *)
  | Happenings of Property.prop  (** the mean number of happenings until g of which this is so *)
  | Value_at of Property.num * Rat.t
  (** the mean of a number at a time, until which the bound reaches; g is false *)

(** "f until g" of state predicates, with a bound of the time at which g comes. *)
type question = {
  wanted : wanted;
  claim : Property.prop;  (** f *)
  goal : Property.prop;  (** g *)
  bound : Property.bound;
}

val same_question : question -> question -> bool
(** [same_question a b] is true if [a] and [b] want the same of the same terms with the same bound. *)

val predicates : question -> Property.prop list
(** The predicates of a question; for a number one that mentions it. *)

type t

val make : Instant.context -> question -> t
(** The predicates of a question. *)

val question : t -> question
(** The question itself. *)

val events : t -> Property.event array
(** The events that they speak of. *)

val see_speed : t -> bool
(** [see_speed t] is true if a predicate depends on velocities. *)

val reasons : t -> string list
(** The reasons why a predicate was undecided so far, sorted. *)

val undecided : t -> string -> Chance_tree.tree
(** [undecided t reason] is what follows if nothing is known, for a reason that {!reasons} contains from now on. *)

val not_after_time : Rat.t option -> Zone.t -> Polyhedron.t -> Polyhedron.t list * Polyhedron.t list
(** The regions in which the time of the zone is no later than a bound, and the others. *)

(** What becomes of the states of a region: what the until comes to, or [None] where the run has to go on. Where a
    predicate is undecided, it may come to one of [perhaps] instead. *)
type met = { region : Polyhedron.t; perhaps : Chance_tree.tree list; met : Chance_tree.tree option }

val one_of : Chance_tree.tree list -> Chance_tree.tree -> Chance_tree.tree
(** [one_of perhaps tree] is [tree], or perhaps one of the others. *)

val judged : t -> Zone.t -> met list
(** What becomes of a zone at this instant. *)

val after_time : t -> Linear.t -> Chance_tree.tree -> Chance_tree.tree
(** [after_time t time tree] is what follows if [tree] comes after this time: with the gain, if it counts. *)

val after_happening :
  t -> Zone.t -> source:Scc_calculus.State.t -> Scc_semantics.Transition.label -> Chance_tree.tree ->
  Chance_tree.tree
(** [after_happening t z ~source label tree] is the same for a transition with this label of states of the zone, of
    which [source] is one. *)

val depends_on_instants : t -> bool
(** [depends_on_instants t] is true if an answer may change with the instant of a split by any amount. *)

val at_dead_end : t -> Chance_tree.tree
(** What follows states from which nothing can come. *)

val along : t -> Zone.t -> Passing.due First.cell -> met list
(** [along t z cell] is what becomes of the region of the cell, by what passes by before its next event.
    For a mean time a region has the time at which g begins to hold, and for a number at a time its value there. *)

val along_until_stop :
  t -> Zone.t -> Passing.due First.cell -> Zone.t -> met list
(** [along_until_stop t z cell halted] is what becomes of the zone [halted] ({!Passing.within}), by what passes by
    until time stops. *)
