(** The zones that a network reaches from all its starts, and how: breadth-first, up to zones in others. *)

open Scc_exact
open Scc_polyhedra
open Scc_property

(** Zones that are not expanded yet take in what makes a convex set with them, so that fewer are to be expanded. *)

(** From where the guard holds of the variables of the source. *)
type edge = {
  guard : Polyhedron.t;
  (** over the variables of the source, and of a {!Passes_some} over one more, the last one: the time that passes
  *)
  step : Zone_steps.step;
  target : int;
  map : Linear.t array;  (** the variables of the target, as forms over those of the guard *)
  renamed : int array option;
  (** by what names the target knows the leaves of the source, if not by the same (rule Symmetry) *)
}

type node = {
  number : int;
  mutable zone : Zone.t;  (** canonical *)
  depth : int;  (** how many edges from a root, at least *)
  mutable parents : (int * edge) list;
  (** edges that it was found by, from nodes that were expanded before; together they lead to all of it. None to a
      root. *)
  mutable edges : edge list;
  mutable cells : Passing.due First.cell list;
  (** regions on which time passes, with what comes first: until then it does so undisturbed *)
  mutable late : Polyhedron.t list;
  (** from where what comes next comes after the horizon: over the variables of the node *)
  mutable expanded : bool;
}

type t

val size : t -> int
val node : t -> int -> node
val roots : t -> node list

(** How far it goes; [None]: no bound. *)
type limits = {
  depth : int option;
  nodes : int option;
  horizon : Rat.t option;  (** of time, where zones know it: what comes later is left out *)
}

type end_ =
  | Closed  (** all is known *)
  | Decided  (** whoever looked on wanted no more *)
  | Bounded of { depth : bool; nodes : bool }  (** some nodes were not expanded, for these bounds *)
  | Stopped  (** somebody wanted it *)
  | Not_affine of string  (** what comes of some node is not affine, or not known, for this reason *)

type visitor = {
  found : node -> unit;
  expanded : node -> unit;
  late : Zone.t -> unit;  (** what the horizon left out, in part at least *)
  enough : unit -> bool;  (** asked before each node *)
  stop : unit -> bool;  (** likewise *)
}

val explore :
  ?displaced:bool ->
  ?visible:(int -> bool) ->
  ?interchangeable:int list list ->
  ?attempt:((unit -> unit) -> bool) ->
  Instant.context ->
  events:Property.event array ->
  limits:limits ->
  visitor:visitor ->
  Zone.t list ->
  t * end_
(** From zones, which need not be canonical: the roots are their canonical forms. With [displaced] each zone that
    is reached is {!Zone.centred} first: where the whole is does not matter. With [visible], independent events of
    one instant are followed in one order where nobody looks at who makes them (rule Order): for searches alone.
    Of [interchangeable] leaves, class by class with the members increasing, it does not matter which of them is
    where (rule Symmetry); the roots are as they are.
    Each node is expanded by [attempt], which may give it up wherever it is, and answer false: then the
    exploration is stopped, and the node is not expanded. *)
