(** Which normals of the contacts of two bodies count in a response (reading I-13), for turning bodies.

    Take the space of the relative translation of the two bodies, and in it the obstacles of their pairs of parts.
    A contact is seen where its gap is closed: at the point of its obstacle that is nearest to where the bodies are
    now. There its extreme directions are dropped whose facets are covered by the obstacles of other pairs. When
    none is dropped, the contact has the normals that it has ({!Near_contact.t}); else it has the directions that
    are left. So a tip that comes down beside the seam of two flush tiles sees a flat floor. *)

open Scc_exact

val counting : (Near_contact.t * bool) list -> (Near_contact.t * Ivec.t list) list
(** Given all contacts of two bodies, and whether each approaches: the normals of each that count, none of those
    that do not approach. When nothing would be left, all normals of those that approach count. *)
