(** For which values of the parameters a check holds: the box of their ranges ({!Scc_calculus.Ranges}), parted into
    three sets. They are exact, their borders included or not; a set may have no volume and still not be empty. *)

open Scc_exact
open Scc_polyhedra
open Scc_calculus

type t = private {
  ranges : Ranges.t;
  holds : Union.t;
  fails : Union.t;
  unknown : Union.t;  (** where it is not known which of both *)
}
(** No two of all pieces overlap, no two pieces of a set are together convex, and the pieces of a set are in
    {!order}. *)

(** {1 Making} *)

val make : Ranges.t -> holds:Union.t -> fails:Union.t -> t
(** What is in the box of the ranges and in neither set is unknown; what is not in the box is left out. Pieces of
    one set may overlap. The two sets have no point in common, and no range is one point (bugs otherwise). *)

val decided : Ranges.t -> holds:Union.t -> t
(** It fails in the rest of the box. *)

val of_test : Ranges.t -> bool -> t
(** It holds everywhere in the box, or fails everywhere. *)

val tidy : Union.t -> Union.t
(** The same set by disjoint pieces, merged where two of them are together convex, and in order. *)

val order : Polyhedron.t list -> Polyhedron.t list
(** Of disjoint pieces that are not empty: those of a greater dimension first, then by
    {!Polyhedron.interior_point}, coordinate by coordinate. It does not depend on how they are described. *)

(** {1 What it says} *)

val dimension : t -> int
(** The number of parameters. *)

val measure : Union.t -> Rat.t option
(** Of disjoint pieces that are bounded: their volume, in the units of the parameters. 0 does not mean empty.
    [None] if it would take too long to compute ({!Scc_polyhedra.Volume.Not_computed}), which it never does in up
    to 8 dimensions with a few constraints. *)

type measures = { of_holds : Rat.t option; of_fails : Rat.t option; of_unknown : Rat.t option }

val measures : t -> measures
(** Of the three sets: if only one is not computed by itself, it is what the others leave of the box. *)

val whole : t -> Rat.t
(** The volume of the box: the product of the widths of the ranges. 1 where there are none. *)

type probability =
  | Exactly of Rat.t
  | Between of Rat.t * Rat.t  (** different *)
  | Not_computed

val probability : t -> probability
(** That it holds, where the parameters are independent and uniform in their ranges: the volume where it holds over
    that of the box. Where volume is left unknown, what it is if it fails there, and if it holds there. Not
    computed where a measure that it takes is not. *)

(** {1 Judging} *)

val faults : t -> string list
(** For tests: which of the sets overlap, and whether they cover the box and nothing else. Empty if all is well. *)
