(** When two turning convex solids first interpenetrate, exactly: the reference that every faster answer is held
    against, and what decides near contact, in resting and in sliding contact (rule Turn).

    The interiors of two convex solids are disjoint at an instant iff some axis of {!Axis} separates them
    then. Each axis does so on a finite union of closed intervals whose ends are roots of polynomials, hence
    the first instant after which no axis goes on is found by going from the end of one interval to that of
    another. *)

open Scc_exact
open Scc_geometry

type outcome =
  | Never  (** the interiors are disjoint on all of [from, until] *)
  | At of Algebraic.t
  (** The last t in [from, until) such that the interiors are disjoint on [from, t]: they meet right after it. *)

val first_penetration : Motion.t -> Motion.t -> from:Rat.t -> until:Rat.t -> outcome
(** For 0 <= from <= until, times from now as in {!Motion}; the solids do not interpenetrate at [from] (if they
    do, the answer is [At from], or [Never] for [from = until]). A graze, sliding and resting contact are no
    penetration. Exact for every input. The number is a function of the two motions, in either order; the
    polynomial that it is told by need not be. *)

val relation : Motion.t -> Motion.t -> Rat.t -> Obstacle.relation
(** Rule Contact at an instant. Not cheap: both solids are made anew. *)
