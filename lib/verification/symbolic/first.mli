(** What comes first, of events whose times depend on what is not known. *)

open Scc_polyhedra

(** A region on which the next of all events is known. *)
type 'a cell = {
  region : Polyhedron.t;  (** not empty *)
  time : Linear.t option;  (** when the next of all events comes, if any does *)
  due : 'a list;  (** those that come then, all of them, in the order in which they were given *)
}

val start : Polyhedron.t -> 'a cell list
(** No event yet. *)

val at : Linear.t -> 'a -> 'a cell list -> 'a cell list
(** One event more, which comes at this time, at least 0, everywhere. *)

val on :
  (limit:Linear.t option -> Polyhedron.t -> (Polyhedron.t * Linear.t) list * Polyhedron.t list) -> 'a ->
  'a cell list -> 'a cell list
(** One event more. On a region in which the others come no earlier than the limit, if at all, it says where it
    comes at the limit or before, and when; and where not. Both are disjoint pieces, together the region. *)

val merged : ('a -> 'a -> bool) -> 'a cell list -> 'a cell list
(** The same with fewer regions, where the union of some with the same time and events is convex. Events are
    compared by the function. *)
