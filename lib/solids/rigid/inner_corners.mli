(** The normals of the contacts of two turning bodies that count in a response (reading I-13).

    Take the space of the relative translation of the two bodies, and in it the obstacles of their pairs of
    parts. A contact is seen where its gap is closed: at the point of its obstacle that is nearest to where the
    bodies are now. There its extreme directions are dropped whose facets are covered by the obstacles of other
    pairs. When none is dropped, the normals of the contact ({!Near_contact.t}) count; otherwise the directions
    that are left count. So a tip that comes down beside the seam of two flush tiles meets a flat floor. *)

open Scc_exact

val counting : (Near_contact.t * bool) list -> (Near_contact.t * Ivec.t list) list
(** [counting contacts] are the normals that count of each contact. The list has all contacts of two bodies,
    each with true if it approaches. A contact that does not approach has none. If no normal would be left, all
    normals of the approaching contacts count. *)
