(** The values of the parameters for which a check holds: the box of their ranges ({!Scc_calculus.Ranges}),
    divided into three sets. The sets are exact, also in which borders belong to them. A set without volume may
    still have points. *)

open Scc_exact
open Scc_polyhedra
open Scc_calculus

type t = private {
  ranges : Ranges.t;
  holds : Union.t;
  fails : Union.t;
  unknown : Union.t;  (** where neither is known *)
}
(** No two of all pieces overlap, no two pieces of a set are together convex, and the pieces of a set are in
    {!order}. *)

(** {1 Making} *)

val make : Ranges.t -> holds:Union.t -> fails:Union.t -> t
(** [make ranges ~holds ~fails]: the rest of the box of the ranges is unknown; points outside of the box are
    dropped. Pieces of one set may overlap. The two sets have no common point, and no range is one point (bugs
    otherwise). *)

val tidy : Union.t -> Union.t
(** The set, by disjoint pieces, merged where two of them have a convex union, and in {!order}. *)

val order : Polyhedron.t list -> Polyhedron.t list
(** Disjoint pieces, none empty, in order: those of a greater dimension first, then by
    [Polyhedron.interior_point], coordinate by coordinate. The order depends on the sets of points alone. *)

(** {1 What it says} *)

val measure : Union.t -> Rat.t option
(** The volume of a set of disjoint, bounded pieces, in the units of the parameters. A set of volume 0 may
    still have points. [None] if it would take too long to compute ({!Scc_polyhedra.Volume.Not_computed}). That
    never happens in up to 8 dimensions with a few constraints. *)

type measures = { of_holds : Rat.t option; of_fails : Rat.t option; of_unknown : Rat.t option }

val measures : t -> measures
(** The volumes of the three sets. If exactly one cannot be computed directly, it is the rest of the box. *)

val whole : t -> Rat.t
(** The volume of the box: the product of the widths of the ranges, 1 without ranges. *)

type probability =
  | Exactly of Rat.t
  | Between of Rat.t * Rat.t  (** different *)
  | Not_computed

val probability : t -> probability
(** The probability that the check holds, for parameters that are independent and uniform in their ranges. It
    is the volume where it holds, divided by that of the box. If the outcome is unknown on a set of positive
    volume, the bounds are those for failing there and for holding there. [Not_computed] if a measure that it
    needs is not computed. *)
