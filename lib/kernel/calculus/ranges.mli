(** The parameters of a model that are not known but for a range. Parameter i of a model is variable i of all
    affine forms and polyhedra over these parameters. *)

open Scc_exact
open Scc_polyhedra

type bound = { value : Rat.t; included : bool }

type range = { name : string; low : bound; high : bound }
(** The values between [low] and [high], which differ. An end belongs to the range if it is [included]. *)

type t = range array

val name : t -> int -> string
(** [name ranges i] is the name of variable [i], in the form that {!Scc_polyhedra.Text} takes. *)

val find : t -> string -> int option
(** The variable of the parameter with this name; [None] if there is none. *)

val mem : range -> Rat.t -> bool
(** [mem range x] is true if [x] lies in [range]. *)

val box : t -> Polyhedron.t
(** All values that the parameters may have, as a polyhedron with one dimension for each parameter. *)

val point : t -> Rat.t array
(** A simple value of each parameter, strictly between the ends of its range. *)

val negative : t -> Linear.t -> (string * Rat.t) list option
(** [negative ranges form] is values of the parameters at which [form] is negative, by name; [None] if there are
    none. It lists only the parameters that the form depends on. *)

val may_be_zero : t -> Linear.t -> bool
(** [may_be_zero ranges form] is true if [form] is zero for some values of the parameters. *)

val values_to_string : t -> Rat.t array -> string
(** A value for each parameter, as text: ["x = 1, y = 1/2"]. *)

val range_to_string : range -> string
(** The range as text, with the brackets of its ends: ["x in (0, 6\]"]. *)

val to_string : t -> string
(** All ranges as text, separated by commas: ["x in [0, 6], y in (0, 1/2\]"]. *)
