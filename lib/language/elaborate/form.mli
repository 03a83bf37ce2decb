(** Values that depend on parameters of which ranges are known: affine forms over those parameters, while it is not
    known yet how many there are. *)

open Scc_exact
open Scc_polyhedra

type variable = { index : int;  (** in order of declaration *) name : string }

type t = private { constant : Rat.t; terms : (variable * Rat.t) list }
(** Terms by index, none of them zero. *)

val const : Rat.t -> t
val variable : variable -> t

val constant : t -> Rat.t option
(** Its value, where it has no terms. *)

val neg : t -> t
val scale : Rat.t -> t -> t
val add : t -> t -> t
val sub : t -> t -> t

val bits : t -> int
(** Of all its numbers. *)

val names : t -> string list
(** Of what it depends on. *)

val eval : t -> Rat.t array -> Rat.t
(** Where parameters have these values. *)

val linear : int -> t -> Linear.t
(** Over so many parameters in all. *)

val to_string : t -> string
(** ["2x + y - 1"]. *)

(** {1 Places} *)

type place = t * t * t

val place : Vec.t -> place

val fixed : place -> Vec.t option
(** Where it depends on nothing. *)

val at : Rat.t array -> place -> Vec.t
val add_place : place -> place -> place

val turned : Mat.t -> place -> place
(** The image by a linear map. *)
