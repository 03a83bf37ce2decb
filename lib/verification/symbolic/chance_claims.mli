(** The predicates of an until, on zones and on what passes by between two events (rules Until and Intervals). *)

open Scc_exact
open Scc_polyhedra
open Scc_property
open Scc_state_sets

(** "f until g" of state predicates, with a bound of the time at which g comes. *)
type question = { claim : Property.prop;  (** f *) goal : Property.prop;  (** g *) bound : Property.bound }

val same_question : question -> question -> bool
(** [same_question a b] is true if [a] and [b] are the same terms with the same bound. *)

type t

val make : Instant.context -> question -> t
(** The predicates of a question. *)

val events : t -> Property.event array
(** The events that they speak of. *)

val see_speed : t -> bool
(** [see_speed t] is true if a predicate depends on velocities. *)

val reasons : t -> string list
(** The reasons why a predicate was undecided so far, sorted. *)

val not_after_time : Rat.t option -> Zone.t -> Polyhedron.t -> Polyhedron.t list * Polyhedron.t list
(** The regions in which the time of the zone is no later than a bound, and the others. *)

val judged : t -> Zone.t -> (Polyhedron.t * Chance_tree.tree option) list
(** Regions that divide a zone: where the until is decided at this instant, or not known, and [None] where the
    run has to go on. *)

val along : t -> Zone.t -> Passing.due First.cell -> (Polyhedron.t * Chance_tree.tree option) list
(** [along t z cell] divides the region of the cell in the same way, by what passes by before its next event. *)

val along_until_stop :
  t -> Zone.t -> Passing.due First.cell -> Zone.t -> (Polyhedron.t * Chance_tree.tree option) list
(** [along_until_stop t z cell halted] divides in the same way the zone [halted] ({!Passing.within}), by what
    passes by until time stops. *)
