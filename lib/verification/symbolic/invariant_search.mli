(** Looks for sets of states that no run leaves, by convex envelopes: what comes of a location is put into a
    polyhedron around it and what is there ({!Scc_polyhedra.Hull.join}), which is widened where it does not come
    to rest, and then narrowed. What it finds is larger than what is reached: it can show that something never
    comes, and never that something does (rule Invariants). *)

open Scc_property

type visitor = { stop : unit -> bool; looked_at : locations:int -> waiting:int -> unit }

type end_ =
  | Found of Invariant.t
  | No_end of string  (** why none was found, for a person *)
  | Stopped

val find :
  Instant.context -> events:Property.event array -> most:int -> visitor:visitor -> Zone.t list -> end_
(** From zones that do not keep time, with at most so many locations. How long it takes is bounded by
    {!Scc_polyhedra.Effort}. *)
