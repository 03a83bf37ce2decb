(** The search for sets of states that no run leaves, by convex envelopes. Successors of a location are joined
    with the states of their kind in one polyhedron ({!Scc_polyhedra.Hull.join}). It is widened where the
    iteration does not converge, and then narrowed. The result contains all reachable states, and usually more.
    So it can prove that a state never comes, and never that one comes (rule Invariants). *)

open Scc_property
open Scc_state_sets

type visitor = { stop : unit -> bool; looked_at : locations:int -> waiting:int -> unit }

type end_ =
  | Found of Scc_certificate.Invariant.t
  | No_end of string  (** the reason, for readers, why none was found *)
  | Stopped

val find :
  Instant.context -> events:Property.event array -> most:int -> visitor:visitor -> Zone.t list -> end_
(** [find c ~events ~most ~visitor zones] searches from zones without time, with at most [most] locations. The
    work is bounded by {!Scc_polyhedra.Effort}. *)
