(** The elastic response of a system of bodies to unilateral contacts (Moreau), exact.

    The velocities q of the system are vectors in slots. A contact is a row J of generalized normals: it approaches
    when J q < 0. N is the cone spanned by the rows, and q+ = q + 2 proj_N(-q), the projection in the kinetic
    metric M. The energy q.M q is kept, and where J q < 0 before, J q+ >= -J q after. *)

(** A row, by increasing slots: for each slot that it concerns, its part of J and its part of M{^-1}J{^T}, the
    change of velocity by an impulse of size 1 along the row. *)
type row = (int * Vec.t * Vec.t) list

val reflect : Vec.t array -> row array -> Vec.t array option
(** [reflect q rows] is q+. It is [None] iff J q >= 0 for all rows: then nothing approaches, and q+ = q. *)
