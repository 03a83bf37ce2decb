(** A probability or a mean as a function of the parameters of a model: on each of finitely many polyhedra it is
    constant, or affine, or infinite, or nothing is known of it. *)

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
  parts : part list;  (** by increasing least value, at least one; the sets are disjoint and {!Where.tidy} *)
  unknown : Union.t;
  (** where nothing is known, as of the mean of a number that has no value there: the rest of the box,
      {!Where.tidy} *)
}

val known : Ranges.t -> Piecewise.value -> value
(** [known ranges v] is a number with the two ends of [v], whatever the parameters are. *)

val is_known : value -> bool
(** [is_known v] is true if both ends are one function. *)

val make : Ranges.t -> ?unknown:Polyhedron.t list -> (Polyhedron.t * value) list -> t
(** [make ranges ~unknown pieces] is the function with these values on pieces, at least one, and nothing known on
    [unknown]. All of these are disjoint and not empty, and together the box of the ranges. *)

val known_everywhere : t -> bool
(** [known_everywhere t] is true if something is known for all starts. *)

type ends = { low : Rat.t option; high : Rat.t option }
(** Bounds of a number. Without a lower one it is infinite; without an upper one alone, no bound is known. *)

val ends_of : part -> ends
(** The greatest lower and the least upper bound of the values of a part. *)

val extremes : t -> ends
(** The greatest lower and the least upper bound of the values over all parts. *)

(** What is said of a mean over all starts. *)
type mean =
  | Between of ends
  | Not_known of Rat.t  (** nothing is known for this share of the starts, which is not 0 *)
  | Not_computed  (** a volume is not computed ({!Scc_polyhedra.Volume.Not_computed}) *)

val mean : t -> mean
(** The mean over parameters that are independent and uniform in their ranges: the integral of the function,
    divided by the volume of the box. It is the number for a start that is uniform in the box, if the
    scheduler sees the start. Starts without volume do not count, whatever is known of them. *)

val equal : t -> t -> bool
(** [equal a b] is true if both have the same values on the same pieces, in the same order. *)
