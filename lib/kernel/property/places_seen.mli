(** Which values of coordinates and distances the atoms of formulas tell apart (rule Drift). *)

open Scc_exact
open Scc_calculus

type limits =
  | Between of Rat.t * Rat.t
  (** all values below the first number are equivalent, and all values above the second *)
  | All
  (** no two values are known to be equivalent: a formula compares the number with what may grow as well, or
      computes with it, or has it as its result *)

type t

val checks : Model.t -> Property.check list -> t
(** What the formulas of some checks, and the numbers of which they take the mean, depend on. Facts such as
    [touching] are left out. *)

val coordinates : t -> (Vec.t * int * limits) list
(** The coordinates n.p in the world of the centroids p of leaves: the direction n, the index of the leaf, and the
    limits. The first component of n that is not 0 is 1. Each pair of a direction and a leaf comes once. *)

val distances : t -> (int * int * limits) list
(** The squared distances between the centroids of two leaves, the lesser index first, each pair once. *)

val everything : t -> bool
(** [everything t] is true if an atom depends on the places of all bodies, without bounds: angular momentum. *)

val for_ever : t -> bool
(** [for_ever t] is true if the limits of some coordinate or distance are {!All}, or {!everything} holds. *)
