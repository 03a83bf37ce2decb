(** How much of where bodies are formulas can see (rule Drift): which values of coordinates and distances their
    atoms tell apart. *)

open Scc_exact
open Scc_calculus

type limits =
  | Between of Rat.t * Rat.t  (** all values below the first are the same, and all above the second *)
  | All  (** it is compared with what may get as great, or computed with, or asked for *)

type t

val checks : Model.t -> Property.check list -> t
(** All that some of them see. That two bodies touch is not among it, nor what follows from where they are alone.
*)

val coordinates : t -> (Vec.t * int * limits) list
(** Of the centroids of leaves, along a direction n: the number n.p, p being the place. The first component of n
    that is not 0 is 1, and each direction and leaf comes once. *)

val distances : t -> (int * int * limits) list
(** Squared distances of the centroids of two leaves, each once. *)

val everything : t -> bool
(** An atom depends on where all bodies are, without bounds: angular momentum. *)

val for_ever : t -> bool
(** Some coordinate or distance is told apart without limits. *)
