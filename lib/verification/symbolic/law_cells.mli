(** Laws of motion on sets of states (rule Steer): where a law gives the same velocities, with the same chances.
*)

open Scc_polyhedra
open Scc_calculus
open Scc_state_sets

exception Bad_law of { leaf : int; fault : Law.fault; at : Scc_exact.Rat.t array }
(** The law of a leaf has no value for these values of the parameters. *)

val cells : Instant.context -> Zone.t -> Polyhedron.t -> State.process -> Polyhedron.t list
(** [cells c z region p] divides a region of [z]. On each piece, which is not empty, the laws of the leaves of
    [p] give the same velocities and weights for all states, or have a fault for all of them. Raises
    {!Instant.Not_affine} if a velocity or a weight depends on the place or the time otherwise than by
    conditions, and {!Bad_law} if such a weight is negative somewhere. *)
