(** Values that depend on parameters with known ranges: affine forms over those parameters, while the number of
    parameters is not known yet. *)

open Scc_exact
open Scc_polyhedra

type variable = { index : int;  (** in order of declaration *) name : string }

type t = private { constant : Rat.t; terms : (variable * Rat.t) list }
(** Terms by index, none of them zero. *)

val const : Rat.t -> t
(** The form of a constant. *)

val variable : variable -> t
(** The form of a parameter itself. *)

val constant : t -> Rat.t option
(** The value of a form without terms, and [None] for any other form. *)

val neg : t -> t
(** The negative of a form. *)

val scale : Rat.t -> t -> t
(** [scale k f] is [k] times [f]. *)

val add : t -> t -> t
(** The sum of two forms. *)

val sub : t -> t -> t
(** [sub a b] is [a] minus [b]. *)

val bits : t -> int
(** The number of bits of all numbers of a form, numerators and denominators. *)

val names : t -> string list
(** The names of the parameters on which a form depends, in order of declaration. *)

val linear : int -> t -> Linear.t
(** [linear n f] is the form over [n] parameters in all. *)

val to_string : t -> string
(** The form as a text, such as ["2x + y - 1"]. *)

(** {1 Places} *)

(** A point or vector of three forms. *)
type place = t * t * t

val place : Vec.t -> place
(** The place of a constant vector. *)

val fixed : place -> Vec.t option
(** The vector of a place that depends on no parameter, and [None] for any other place. *)

val at : Rat.t array -> place -> Vec.t
(** [at point p] is the place [p] at the values of the parameters, which are by index. *)

val add_place : place -> place -> place
(** The sum of two places, component by component. *)

val turned : Mat.t -> place -> place
(** [turned m p] is the image of [p] by the linear map [m]. *)
