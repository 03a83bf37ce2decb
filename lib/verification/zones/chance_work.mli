(** The work on a check about chance over starts: its explorations, which checks share, and their reasons. *)

open Scc_calculus
open Scc_property
open Scc_state_sets
open Scc_graph_search
open Scc_polyhedra
open Scc_symbolic
open Scc_verify

type shared
(** The explorations of the checks of a model. *)

val shared : Property.check list -> shared
(** [shared checks] is {!Zone_chance.shared}. *)

val groups : Property.check list -> (int * Property.check) list list
(** [groups checks] is {!Zone_chance.groups}. *)

(** The work on one check. *)
type t = {
  options : Setup.t;
  context : Instant.context;
  ranges : Ranges.t;
  starts : keeps_time:bool -> (Zone.t list, Start.fault) Stdlib.result;
  shared : shared;
  mutable used : Chance_graph.t list;
  mutable explored : Chance_graph.t list;  (** those of [used] that no check has explored before *)
  mutable stop : Limits.stop option;  (** what ended an exploration *)
  mutable graphs : (Chance_claims.question * Chance_graph.t) list;  (** what was explored or taken over *)
  mutable eighths : int;  (** how many eighths of the layers have values if the exploration was stopped *)
}

val make :
  Setup.t -> Instant.context -> shared -> starts:(keeps_time:bool -> (Zone.t list, Start.fault) Stdlib.result) -> t
(** [make options c shared ~starts] is work that has not begun. [starts] is all starts, as zones. *)

exception Ill_formed of Start.fault
(** Some start is not well-formed. *)

val sure : t -> Limits.stage -> (unit -> 'a) -> 'a
(** [sure w stage f] is [f ()], run as an attempt of this stage.
    @raise Limits.Over if that is given up. *)

val zones : t -> keeps_time:bool -> Zone.t list
(** [zones w ~keeps_time] is all starts.
    @raise Ill_formed if one of them is not well-formed. *)

val begin_with : t -> Chance_claims.question -> unit
(** [begin_with w q] explores for [q], or takes what another check has explored; once for each until of a check. *)

val explore : t -> Chance_claims.question -> Chance_graph.t
(** [explore w q] is the graph of a question after {!begin_with}. *)

val most_layers : t -> Chance_graph.t -> int
(** [most_layers w graph] is how many layers of a graph, from the first on, are to have values: all, or the part
    [eighths] where the exploration was stopped. *)

val valued : t -> sets:int -> all:int -> unit
(** [valued w ~sets ~all] shows that so many sets of states, of all, have a value. *)

val box : t -> Polyhedron.t
(** [box w] is the polyhedron of all starts: one dimension for each parameter, within its range. *)

val reasons : t -> Verdict.truncation list * Verdict.reason list
(** [reasons w] is the bounds that were met, and all reasons why something is open: bounds, and predicates. *)

val stats : t -> faults:Scc_base.Diag.t list -> Stats.t
(** [stats w ~faults] is the numbers of what was explored for this check. *)
