(** A probability or a mean as a function of the parameters of a model: on each of finitely many polyhedra it is
    constant, or affine, or infinite. *)

open Scc_exact
open Scc_polyhedra
open Scc_calculus

(** What is known of the function on a set, by forms over the parameters; [None] is infinite. *)
type value = { least : Linear.t option; most : Linear.t option }

type part = {
  value : value;  (** the number, or proved bounds of it *)
  set : Union.t;  (** the values of the parameters for which it is so; not empty *)
}

type t = private {
  ranges : Ranges.t;
  parts : part list;
  (** by increasing least value; the sets are disjoint, {!Where.tidy}, and together the whole box *)
}

val known : Ranges.t -> Piecewise.value -> value
(** [known ranges v] is a number with the two ends of [v], whatever the parameters are. *)

val is_known : value -> bool
(** [is_known v] is true if both ends are one function. *)

val make : Ranges.t -> (Polyhedron.t * value) list -> t
(** [make ranges pieces] is the function with these values on disjoint pieces, none empty, that together are the
    box of the ranges. *)

type ends = { low : Rat.t option; high : Rat.t option }
(** Bounds of a number. Without a lower one it is infinite; without an upper one alone, no bound is known. *)

val ends_of : part -> ends
(** The greatest lower and the least upper bound of the values of a part. *)

val extremes : t -> ends
(** The greatest lower and the least upper bound of the values over the whole box. *)

val mean : t -> ends option
(** The mean over parameters that are independent and uniform in their ranges: the integral of the function,
    divided by the volume of the box. It is the number for a start that is uniform in the box, if the
    scheduler sees the start. [None] if a volume is not computed ({!Scc_polyhedra.Volume.Not_computed}). *)

val equal : t -> t -> bool
(** [equal a b] is true if both have the same values on the same pieces, in the same order. *)
