(** The states of a zone at one instant, divided by the events that happen to them. On each region all inputs
    of the discrete rules are the same. So the result of the rules for one state is valid for the whole
    region. *)

open Scc_polyhedra
open Scc_state_sets

include module type of struct
  include Zone_parts
end

exception Not_affine of string
(** The reason, for readers, why the numbers of successors of a zone are not affine, or not known. *)

val meeting_offsets : context -> part * part -> Polyhedron.t list
(** Sets of offsets at which features have a common point (reading I-33). There is one for each two features,
    which are closed, that two parts list for channels that are open now and fit. *)

val cells : context -> Zone.t -> Polyhedron.t list
(** Regions of the zone that are disjoint, not empty, and whose union is the zone. Throughout each of them, the
    same parts collide, and all contacts between the processes that collide are the same. The same features of
    open channels touch, and closings and pushes have the same results. With [binding contact], all contacts
    between parts with open channels that fit are the same, too. Collisions are not considered in
    {!Scc_state_sets.Zone.t.halted} zones. Raises {!Not_affine} for a push along an unknown line. *)
