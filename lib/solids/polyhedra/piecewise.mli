(** Functions that are constant on each of finitely many convex polyhedra: decision diagrams over linear
    constraints, as in S. Chaki, A. Gurfinkel and O. Strichman, {e Decision diagrams for linear arithmetic} (FMCAD
    2009), with numbers at their leaves. A function has a value with two ends at each point, or no value. Which
    borders belong to which piece is exact. *)

open Scc_exact

(** A number of which two ends are known; they are equal if the number is known. *)
type value = { least : Rat.t; most : Rat.t }

type space
(** Where diagrams are made, with all nodes that were made. Diagrams of different spaces are not mixed. *)

val space : unit -> space
(** A space without functions. The functions of a space may be over different numbers of variables; those that are
    combined are over the same ones. *)

type t
(** A function. Equal functions need not be the same diagram. *)

val constant : space -> value -> t
(** The function with this value everywhere. *)

val nowhere : space -> t
(** The function without values. *)

val within : space -> Constraint.t list -> t -> t
(** [within s constraints f] is [f] where all constraints hold, and has no value elsewhere. *)

val first : space -> t -> t -> t
(** [first s f g] is [f] where that has a value, and [g] elsewhere. *)

val sum : space -> (Rat.t * t) list -> t
(** The sum of functions, each times a number that is at least 0. It has a value where all of them have. *)

val least : space -> t -> t -> t
(** The lesser value, by each end; where one has no value, that of the other. *)

val greatest : space -> t -> t -> t
(** The greater value, by each end; where one has no value, that of the other. *)

val ends : space -> t -> t -> t
(** [ends s f g] is the function whose value has the lower end of that of [f] and the upper end of that of [g]. It
    has a value where both have. *)

val preimage : space -> dimension:int -> Linear.t array -> Polyhedron.t -> t -> t
(** [preimage s ~dimension forms set f] is the function x -> f(forms(x)) over [dimension] variables, where
    forms(x) is in [set]. Elsewhere its values have no meaning. *)

val pieces : Polyhedron.t -> t -> (Polyhedron.t * value option) list
(** [pieces p f] is the function on [p]: disjoint polyhedra, none empty, whose union is [p], with the value there.
    There may be several with one value. *)
