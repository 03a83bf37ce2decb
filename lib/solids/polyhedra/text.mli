(** Constraints and sets as texts. The function [name] gives the names of the variables. *)

val form : name:(int -> string) -> Linear.t -> string
(** A form as ["2x + 1/2 y - 3"]: the variables in the order of their numbers, the constant last. *)

val constraint_ : name:(int -> string) -> Constraint.t -> string
(** A constraint without minus signs before variables: ["x <= 2"], ["2x + 3y < 5"], ["x = y"], ["x + 1 <= 2y"].
    With one variable the bound may be a fraction: ["x > 3/2"]. With no variable, it is ["true"] or ["false"].
*)

val polyhedron : name:(int -> string) -> Polyhedron.t -> string
(** The constraints of the minimal form, separated by commas, equalities first: ["x = y, z < 2"]. All points
    are ["true"], none are ["false"]. *)

(** {1 SMT-LIB}

    Terms of sort Bool over constants of sort Real, of SMT-LIB 2.6. Names that are no simple symbols of SMT-LIB
    are quoted; they have no ['|'] or ['\\']. *)

val smt_symbol : string -> string
(** [smt_symbol name] is [name], between bars if it is no simple symbol of SMT-LIB 2.6 or a reserved word. *)

val smt_constraint : name:(int -> string) -> Constraint.t -> string
(** A constraint as a term: a relation between a sum of multiples of variables and a constant. Without
    variables it is [true] or [false]. *)

val smt_form : name:(int -> string) -> Linear.t -> string
(** A form as a term: a sum of multiples of variables and of the constant. *)

val smt_polyhedron : name:(int -> string) -> Polyhedron.t -> string
(** The conjunction of the constraints of the minimal form; [true] for all points. *)

val smt_union : name:(int -> string) -> Union.t -> string
(** The disjunction of the pieces; [false] for no piece. *)
