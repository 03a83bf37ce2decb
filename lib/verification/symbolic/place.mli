(** Points of space whose coordinates are affine forms over what is not known. World frame, units of length. *)

open Scc_exact
open Scc_polyhedra

type t = Linear.t * Linear.t * Linear.t

val constant : int -> Vec.t -> t
(** [constant n v]: v, with coordinates over n variables. *)

val add : t -> t -> t
val sub : t -> t -> t

val moved : t -> Vec.t -> Linear.t -> t
(** [moved p v t]: where a point is that moves with the velocity v, after the time t. *)

val is_constant : t -> bool

val eval : t -> Rat.t array -> Vec.t
(** At a point of the space of what is not known. *)

val map : (Linear.t -> Linear.t) -> t -> t
val coordinates : t -> Linear.t list
val compose : t -> dimension:int -> Linear.t array -> t
(** Coordinate by coordinate ({!Linear.compose}). *)

val of_part : dimension:int -> Linear.t array -> Scc_calculus.Model.part -> t
(** How far the reference point of a part is from that of its leaf, where the parameters are these forms over so
    many variables. *)
