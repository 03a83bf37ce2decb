(** The exact first penetration of two turning convex solids (rule Turn). It is the reference for every faster
    answer, and decides near contact, and resting and sliding contact.

    The interiors of two convex solids are disjoint at an instant iff some axis of {!Axis} separates them then.
    Each axis does so on a finite union of closed intervals whose ends are roots of polynomials. So the search
    goes from the end of one interval to that of another, until no axis goes on. *)

open Scc_exact
open Scc_geometry

type outcome =
  | Never  (** the interiors are disjoint on all of [from, until] *)
  | At of Algebraic.t
  (** the last t, [from] <= t < [until], such that the interiors are disjoint from [from] to t: they meet right
      after it *)

val first_penetration : Motion.t -> Motion.t -> from:Rat.t -> until:Rat.t -> outcome
(** [first_penetration a b ~from ~until], for 0 <= from <= until, where times count from now as in {!Motion}.
    The solids do not interpenetrate at [from]; if they do, the answer is [At from], or [Never] for [from =
    until]. A graze, sliding and resting contact are no penetration. Exact for every input. The number is a
    function of the two motions, in either order; the polynomial that represents it need not be. *)

val relation : Motion.t -> Motion.t -> Rat.t -> Obstacle.relation
(** [relation a b t] is the relation of the two solids at the time [t] (rule Contact). Not cheap: both solids
    are made anew. *)
