(** For which values of the parameters some reachable state satisfies a predicate: collected while zones are
    explored. *)

open Scc_exact
open Scc_polyhedra
open Scc_property

(** Where a run is taken to for it, and what holds there: to some states of a node, or to some while time passes
    after it. *)
type place = {
  node : Zone_graph.node;
  states : Polyhedron.t;  (** over the variables of the node; and of the time that has passed, the last one *)
  passing : bool;
  prop : Property.prop;
}

type t

val make : Atoms.context -> parameters:int -> bound:Rat.t option -> Property.prop -> t
(** Of the states up to a bound of time since the start. *)

val look : Instant.context -> t -> Zone_graph.node -> unit
(** At a node that is expanded, and at what time makes of it. *)

val look_at : t -> Zone_graph.node -> unit
(** At the node alone. *)

val look_around : t -> Zone_graph.node -> unit
(** At a node that is not, and never will be: beyond it nothing is known. *)

val leave : t -> Zone.t -> unit
(** What was left out, and matters. *)

val found : t -> Union.t
(** Values for which there is such a state. *)

val open_ : t -> Union.t
(** Values for which there may be one that was not seen, or that could not be judged; others of them may be
    {!found} all the same. *)

val reasons : t -> string list
(** Why something could not be judged. *)

val covers : t -> Polyhedron.t -> bool
(** Whether all values of a set are {!found}. *)

val first : t -> place option
(** Where one was found first. *)

val asks_for_rest : Property.prop -> bool
(** Whether it asks for what is only known of nodes that are expanded: that nothing ever happens again. *)
