(** Constraints and sets as texts. Variables are called by the function [name]. *)

val form : name:(int -> string) -> Linear.t -> string
(** ["2x + 1/2 y - 3"]: variables by their numbers, the constant last. *)

val constraint_ : name:(int -> string) -> Constraint.t -> string
(** Without minus signs before variables: ["x <= 2"], ["2x + 3y < 5"], ["x = y"], ["x + 1 <= 2y"]; of one
    variable with a fraction, ["x > 3/2"]. Of none, ["true"] or ["false"]. *)

val polyhedron : name:(int -> string) -> Polyhedron.t -> string
(** The minimal form, separated by commas, equalities first: ["x = y, z < 2"]; ["true"] or ["false"] for all
    points or none. *)

val union : name:(int -> string) -> Union.t -> string
(** The pieces, separated by [" or "], in brackets if there are several. *)

(** {1 SMT-LIB}

    Terms of sort Bool over constants of sort Real, of SMT-LIB 2.6; names that are no simple symbols of it are
    quoted (they have no ['|'] or ['\\']). *)

val smt_symbol : string -> string
val smt_constraint : name:(int -> string) -> Constraint.t -> string
val smt_polyhedron : name:(int -> string) -> Polyhedron.t -> string
val smt_union : name:(int -> string) -> Union.t -> string
