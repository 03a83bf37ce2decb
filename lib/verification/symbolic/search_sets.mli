(** The values of the parameters for which some reachable state satisfies a predicate. They are collected while
    zones are explored. *)

open Scc_exact
open Scc_polyhedra
open Scc_property
open Scc_state_sets

(** The end of a run, and the predicate that holds there: some states of a node, or states that pass by after
    it. *)
type place = {
  node : Zone_graph.node;
  states : Polyhedron.t;  (** over the variables of the node; if [passing], also over the time that has passed,
                              the last variable *)
  passing : bool;
  prop : Property.prop;
}

type t

val make : Atoms.context -> parameters:int -> bound:Rat.t option -> Property.prop -> t
(** [make atoms ~parameters ~bound prop] is the search for states up to a bound of time since the start, over
    the values of [parameters] parameters. *)

val look : Instant.context -> t -> Zone_graph.node -> unit
(** Searches a node that is expanded, and the states that pass by after it. *)

val look_at : t -> Zone_graph.node -> unit
(** Searches the states of the node alone. *)

val look_around : t -> Zone_graph.node -> unit
(** Searches a node that is never expanded. Later states are unknown. *)

val leave : t -> Zone.t -> unit
(** Notes states that were left out, as far as they are within the bound of time. *)

val found : t -> Union.t
(** The values for which there is such a state. *)

val open_ : t -> Union.t
(** The values for which there may be a state that was not explored, or could not be decided. Some of them may
    be {!found} all the same. *)

val reasons : t -> string list
(** The reasons why something could not be decided. *)

val covers : t -> Polyhedron.t -> bool
(** [covers t set] is true if all values of the set are {!found}. *)

val first : t -> place option
(** The place that was found first. *)

val asks_for_rest : Property.prop -> bool
(** [asks_for_rest prop] is true if the predicate has the atom [quiescent]: that nothing ever happens again. It
    is known only for nodes that are expanded. *)
