(** A probability as a function of the parameters of a model: constant on each of finitely many polyhedra. *)

open Scc_polyhedra
open Scc_calculus

type part = {
  value : Piecewise.value;  (** the probability, or proved bounds of it *)
  set : Union.t;  (** the values of the parameters for which it is so; not empty *)
}

type t = private {
  ranges : Ranges.t;
  parts : part list;  (** by increasing value; the sets are disjoint, {!Where.tidy}, and together the whole box *)
}

val make : Ranges.t -> (Polyhedron.t * Piecewise.value) list -> t
(** [make ranges pieces] is the function with these values on disjoint pieces, none empty, that together are the
    box of the ranges. *)

val extremes : t -> Piecewise.value
(** The least of the lower bounds, and the greatest of the upper bounds, over the whole box. *)

val mean : t -> Piecewise.value option
(** The mean over parameters that are independent and uniform in their ranges: the sum of all values, each times
    the volume of its set, divided by that of the box. It is the probability for a start that is uniform in the
    box, if the scheduler sees the start. [None] if a volume is not computed
    ({!Scc_polyhedra.Volume.Not_computed}). *)

val equal : t -> t -> bool
(** [equal a b] is true if both have the same values on the same pieces, in the same order. *)
