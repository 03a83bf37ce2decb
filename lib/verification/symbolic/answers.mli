(** The values of the parameters for which a formula holds. Searches ({!Scc_property.Plan}) are decided while
    zones are explored, other formulas on the graph, as far as it is explored ({!Branching}). *)

open Scc_polyhedra
open Scc_property
open Scc_state_sets

type t

val make : Instant.context -> Atoms.context -> parameters:Polyhedron.t -> Property.temporal -> t
(** [make c atoms ~parameters formula] is the open question, where [parameters] are all values of the
    parameters. *)

val reach : t -> Plan.reach option
(** [reach t] is the positions that the truth of the formula of [t] in the initial states depends on
    ({!Scc_property.Plan.reach}); [None] if there is no such bound. *)

val needs_time : Property.temporal -> bool
(** [needs_time formula] is true if the formula mentions model time or has a bound of time. Model time then has
    to be a coordinate of zones. *)

val is_search : t -> bool
(** [is_search t] is true if searches alone decide the formula. *)

(** {1 While zones are explored} *)

val look : t -> Zone_graph.node -> unit
(** Updates the searches with a node that has been expanded. *)

val look_around : t -> Zone_graph.node -> unit
(** Updates the searches with a node that will never be expanded. *)

val leave : t -> Zone.t -> unit
(** Updates the searches with states that are beyond the horizon. *)

val is_known : t -> exactly:bool -> bool
(** [is_known t ~exactly] is true if it is known that the formula holds for all values, or that it fails for
    some. With [exactly], it is true if the set of values is known. *)

(** {1 Afterwards} *)

val conclude : t -> Zone_graph.t -> unit
(** Decides what no search decides, on a graph. It may be called again when more is explored. Where a bound of
    time has ended a graph that has all nodes expanded, {!reach} has no later states. *)

type sets = { holds : Union.t; fails : Union.t  (** disjoint; for all other values it is not known *) }

val sets : t -> sets
(** The values for which the formula holds, and those for which it fails, as far as is known. *)

val safe_so_far : t -> bool
(** [safe_so_far t] is true if the formula says that nothing bad happens, and nothing bad was found. Doubts
    then come only from unexplored states. *)

val reasons : t -> string list
(** The reasons why something could not be decided, sorted, each once. *)

val shown_by : t -> holds:bool -> Search_sets.place option
(** A place to which a run leads that shows that the formula holds, or fails, for some values. [None] if no
    single run of the searches does. *)

val run : t -> Zone_graph.t -> holds:bool -> Shown_run.t option
(** A run that shows that the formula holds, or fails, after {!conclude}. It is for formulas that no search
    decides. *)
