(** Affine forms c + a{_0} x{_0} + ... + a{_n-1} x{_n-1} over n variables with rational coefficients:
    positions, delays and times as functions of parameters. The variables are numbered from 0. Their number n,
    the dimension, is part of a form; an operation on forms of different dimensions is a bug. *)

open Scc_exact

type t = private { constant : Rat.t; coefficients : Rat.t array }

val make : constant:Rat.t -> Rat.t array -> t
(** [make ~constant coefficients] is the form whose dimension is the length of the array, which is copied. *)

val constant : int -> Rat.t -> t
(** [constant n c] is the form over n variables whose value is [c] everywhere. *)

val variable : int -> int -> t
(** [variable n i] is the form x{_i} over n variables, for 0 <= i < n (a bug otherwise). *)

val of_terms : int -> constant:Rat.t -> (int * Rat.t) list -> t
(** [of_terms n ~constant terms] is the sum of the constant and of the terms, each a variable and its
    coefficient. A variable may occur several times. A variable outside of 0 .. n - 1 is a bug. *)

val dimension : t -> int
(** The number n of variables, those with coefficient 0 included. *)

val coefficient : t -> int -> Rat.t
(** [coefficient f i] is the coefficient of x{_i}. *)

val is_constant : t -> bool
(** [is_constant f] is true if all coefficients of variables are 0. *)

val add : t -> t -> t
(** [add f g] is f + g. *)

val sub : t -> t -> t
(** [sub f g] is f - g. *)

val neg : t -> t
(** [neg f] is -f. *)

val scale : Rat.t -> t -> t
(** [scale k f] is k f. *)

val eval : t -> Rat.t array -> Rat.t
(** [eval f x] is the value of [f] at the point [x], which has n coordinates (a bug otherwise). *)

val compose : t -> dimension:int -> t array -> t
(** [compose f ~dimension forms] has [forms.(i)], a form over [dimension] variables, in place of x{_i}. The
    array has a form for each variable of [f] (a bug otherwise). *)

val equal : t -> t -> bool
(** [equal f g] is true if dimensions, constants and all coefficients are the same. *)

val compare : t -> t -> int
(** A total order: by dimensions, then by coefficients, then by constants. *)

val hash : t -> int
(** A hash that is compatible with {!equal}. *)
