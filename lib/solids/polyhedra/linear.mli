(** Affine forms c + a{_0} x{_0} + ... + a{_n-1} x{_n-1} over n variables with rational coefficients: what
    positions, delays and time are as functions of parameters. The variables are numbers; the number n of them,
    the dimension, is part of a form, and forms of different dimensions do not mix (a bug). *)

open Scc_exact

type t = private { constant : Rat.t; coefficients : Rat.t array }

val make : constant:Rat.t -> Rat.t array -> t
(** The array is copied. *)

val constant : int -> Rat.t -> t
(** [constant n c]: c, as a form over n variables. *)

val variable : int -> int -> t
(** [variable n i]: x{_i}, for 0 <= i < n. *)

val of_terms : int -> constant:Rat.t -> (int * Rat.t) list -> t
(** The sum of the constant and of the terms, each a variable and its coefficient; a variable may occur again. *)

val dimension : t -> int

val coefficient : t -> int -> Rat.t

val is_constant : t -> bool

val add : t -> t -> t
val sub : t -> t -> t
val neg : t -> t
val scale : Rat.t -> t -> t

val eval : t -> Rat.t array -> Rat.t
(** At a point, which has a coordinate for each variable. *)

val compose : t -> dimension:int -> t array -> t
(** [compose f ~dimension forms] has [forms.(i)], a form over so many variables, in the place of x{_i}. *)

val equal : t -> t -> bool

val compare : t -> t -> int
(** A total order. *)

val hash : t -> int
