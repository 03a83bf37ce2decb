(** The parameters of a model that are not known but for a range. Parameter i of a model is variable i of all
    affine forms and polyhedra that speak of it. *)

open Scc_exact
open Scc_polyhedra

type bound = { value : Rat.t; included : bool }

type range = { name : string; low : bound; high : bound }
(** Of values between the two, which are different; the ends belong to it where they are included. *)

type t = range array

val name : t -> int -> string
(** Of a variable, as {!Scc_polyhedra.Text} asks for it. *)

val find : t -> string -> int option
(** The variable of the parameter of that name. *)

val mem : range -> Rat.t -> bool

val box : t -> Polyhedron.t
(** All values that the parameters may have. *)

val point : t -> Rat.t array
(** Simple numbers within them, and not at their ends. *)

val negative : t -> Linear.t -> (string * Rat.t) list option
(** Values of the parameters that the form depends on at which it is negative, by name, if there are any. *)

val may_be_zero : t -> Linear.t -> bool
(** Whether the form is zero for some values. *)

val range_to_string : range -> string
(** ["x in (0, 6]"]. *)

val to_string : t -> string
(** ["x in [0, 6], y in (0, 1/2]"]. *)
