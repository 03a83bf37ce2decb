(** The elastic response of a system of bodies to unilateral contacts (Moreau), exact.

    The velocities q of the system are vectors in slots. A contact is a row J of generalized normals: it approaches
    when J q < 0. N is the cone spanned by the rows, and q+ = q + 2 proj_N(-q), the projection in the kinetic
    metric M. The energy q.M q is kept, and where J q < 0 before, J q+ >= -J q after. *)

(** A row: of each slot that it concerns, its part of J and of M{^-1}J{^T}, what an impulse of size 1 along the row
    changes. Slots rise. *)
type row = (int * Vec.t * Vec.t) list

val reflect : Vec.t array -> row array -> Vec.t array option
(** q+. [None] iff J q >= 0 for all rows: nothing approaches, and nothing would change. *)
