(** For which values of the parameters a formula holds: what searches decide ({!Scc_property.Plan}), from what was
    found while zones were explored, and all else from the whole graph ({!Branching}). *)

open Scc_exact
open Scc_polyhedra
open Scc_property

type t

val make : Instant.context -> Atoms.context -> parameters:Polyhedron.t -> Property.temporal -> t
(** [parameters] are all values that they may have. *)

val bound : t -> Rat.t option
(** The latest instant that it asks about; [None]: there is none. *)

val needs_time : Property.temporal -> bool
(** Whether model time has to be a coordinate of zones for it. *)

(** {1 While zones are explored} *)

val look : t -> Zone_graph.node -> unit
(** At a node that has been expanded. *)

val look_around : t -> Zone_graph.node -> unit
(** At a node that will never be. *)

val leave : t -> Zone.t -> unit
(** What the horizon left out. *)

val is_known : t -> exactly:bool -> bool
(** Whether it is known that it holds for all values, or that it does not; with [exactly], for which. *)

(** {1 Afterwards} *)

val conclude : t -> Zone_graph.t -> unit
(** All is known of the graph, up to the latest bound. *)

type sets = { holds : Union.t; fails : Union.t  (** disjoint; elsewhere it is not known *) }

val sets : t -> sets

val safe_so_far : t -> bool
(** It says that nothing bad happens, and what was seen is not bad: where it is not known, it is for what was not
    explored. *)

val reasons : t -> string list
(** Why something could not be judged. *)

val shown_by : t -> holds:bool -> Search_sets.place option
(** A place that a run leads to which shows that it holds, or does not, for some values; [None]: no single run of
    those that were searched for does. *)

val run : t -> Zone_graph.t -> holds:bool -> Shown_run.t option
(** After {!conclude}: a run that shows it, of a formula that no search decides. *)
