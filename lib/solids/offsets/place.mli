(** Points of space whose coordinates are affine forms over variables. World frame, units of length. *)

open Scc_exact
open Scc_polyhedra

type t = Linear.t * Linear.t * Linear.t

val constant : int -> Vec.t -> t
(** [constant n v] is [v], with coordinates over n variables. *)

val add : t -> t -> t
(** [add p q] is the sum, coordinate by coordinate. *)

val sub : t -> t -> t
(** [sub p q] is p - q: the vector from [q] to [p]. *)

val moved : t -> Vec.t -> Linear.t -> t
(** [moved p v t] is the place of a point at [p] that moves with the velocity [v], after the time [t]. *)

val within : Polyhedron.t -> t -> Constraint.t list
(** [within set p] holds where [p] is in [set], a polyhedron of dimension 3. *)

val is_constant : t -> bool
(** [is_constant p] is true if no variable occurs in any coordinate. *)

val eval : t -> Rat.t array -> Vec.t
(** [eval p x] is the place for the values [x] of the variables. *)

val map : (Linear.t -> Linear.t) -> t -> t
(** [map f p] applies [f] to each coordinate. *)

val coordinates : t -> Linear.t list
(** The list of x, y and z. *)

val compose : t -> dimension:int -> Linear.t array -> t
(** [compose p ~dimension forms] applies {!Scc_polyhedra.Linear.compose} to each coordinate. *)
