(** Functions that have one value on each of finitely many convex polyhedra: decision diagrams over linear
    constraints, as in S. Chaki, A. Gurfinkel and O. Strichman, {e Decision diagrams for linear arithmetic} (FMCAD
    2009), with values at their leaves. Which borders belong to which piece is exact. *)

(** What stands at a leaf: a number, or a function of the variables. *)
module type Value = sig
  type t

  val equal : t -> t -> bool
  (** [equal v w] is true if both are the same value. *)

  val hash : t -> int
  (** A hash that is compatible with [equal]. *)

  val any : t
  (** Some value. *)

  val compose : t -> dimension:int -> Linear.t array -> t
  (** [compose v ~dimension forms] is the value x -> v(forms(x)) over [dimension] variables. *)
end

(** What two functions are combined by: results are cached by it and the functions. *)
type operation = Restrict | First | Add | Least | Greatest | Ends

(** What two values give: one value, or none; or one where a constraint holds, and another one elsewhere. *)
type 'v cut = One of 'v option | Cut of Constraint.t * 'v * 'v

(** Functions with such values. *)
module type S = sig
  type value
  (** What stands at a leaf. *)

  type space
  (** Where diagrams are made, with all nodes that were made. Diagrams of different spaces are not mixed. *)

  val space : unit -> space
  (** A space without functions. The functions of a space may be over different numbers of variables; those that
      are combined are over the same ones. *)

  type t
  (** A function, which need not have a value everywhere. Equal functions need not be the same diagram. *)

  val constant : space -> value -> t
  (** The function with this value everywhere. *)

  val nowhere : space -> t
  (** The function without values. *)

  val within : space -> Constraint.t list -> t -> t
  (** [within s constraints f] is [f] where all constraints hold, and has no value elsewhere. *)

  val first : space -> t -> t -> t
  (** [first s f g] is [f] where that has a value, and [g] elsewhere. *)

  val combine : space -> operation -> (value option -> value option -> value option) -> t -> t -> t
  (** [combine s o of_values f g] has the value [of_values v w] where [f] has [v] and [g] has [w]. One [o] has one
      function [of_values] throughout a space. *)

  val combine_cutting : space -> operation -> (value option -> value option -> value cut) -> t -> t -> t
  (** [combine_cutting s o of_values f g] is like {!combine}, where two values may give two. *)

  val map : space -> (value -> value) -> t -> t
  (** [map s of_value f] has the value [of_value v] where [f] has [v]. *)

  val preimage : space -> dimension:int -> Linear.t array -> Polyhedron.t -> t -> t
  (** [preimage s ~dimension forms set f] is the function x -> f(forms(x)) over [dimension] variables, where
      forms(x) is in [set]. Elsewhere its values have no meaning. *)

  val pieces : Polyhedron.t -> t -> (Polyhedron.t * value option) list
  (** [pieces p f] is the function on [p]: disjoint polyhedra, none empty, whose union is [p], with the value
      there. There may be several with one value. *)
end

module Make (V : Value) : S with type value = V.t
