(** The first of several events whose times are affine in variables. *)

open Scc_polyhedra

(** A region on which the next of all events is known. *)
type 'a cell = {
  region : Polyhedron.t;  (** not empty *)
  time : Linear.t option;  (** the time of the next of all events; [None] if no event comes *)
  due : 'a list;  (** all events at that time, in the order in which they were added *)
}

val start : Polyhedron.t -> 'a cell list
(** [start set] is one region without events; none if the set is empty. *)

val at : Linear.t -> 'a -> 'a cell list -> 'a cell list
(** [at time e cells] adds an event that comes at this time, which is at least 0, everywhere. *)

val on :
  (limit:Linear.t option -> Polyhedron.t -> (Polyhedron.t * Linear.t) list * Polyhedron.t list) -> 'a ->
  'a cell list -> 'a cell list
(** [on comes e cells] adds an event by the function [comes ~limit region]. On a region where the other events
    come no earlier than the limit, it returns two lists. The first has the pieces where [e] comes at the limit
    or before, with its time; the second has the others. All pieces are disjoint, and their union is the
    region. *)

val merged : ('a -> 'a -> bool) -> 'a cell list -> 'a cell list
(** [merged equal cells] has fewer regions, where the union of some with equal time and events is convex.
    Events are compared by [equal]. *)
