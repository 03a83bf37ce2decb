(** How curved solids become polyhedra in a model: what [curved inscribed 1/20] says. *)

open Scc_exact
open Scc_syntax

type t

val none : t

val rough : t
(** What stands for one that was refused, so that no more is said of it. *)

val read : Plain.t -> Ast.name -> Ast.expr -> t
(** The word and the distance, a fraction of the radius. Raises {!Fault.Found}: SC0362 where it is no plain
    number, SC0365 where it is not from {!Curved.least} up to 1/2. *)

val notes : t -> string list
(** How near the polyhedra are that have been asked for, a sentence each. *)

(** What a solid of the original calculus is, in the language. *)
type curved =
  | Sphere of Curved.t * Ast.expr
  | Cylinder of Curved.t * Ast.expr * Ast.expr  (** radius and height *)
  | Cone of Curved.t * Ast.expr * Ast.expr

val curved : t -> Ast.reference -> curved option
(** Of [sphere(r)], [cylinder(r, h)] and [cone(r, h)]. Raises {!Fault.Found}: SC0365 if the model does not say
    how; SC0206 for other arguments. *)

val ball_name : int -> string
(** Of the shape that stands for the ball of radius 1, {!Curved.ball} of so many corners. *)

val solid : Scc_base.Span.t -> curved -> Ast.solid_kind
(** The shape {!ball_name} scaled, a [prism] or a [pyramid], with the factor of what is circumscribed. *)

val radius : Curved.t -> Rat.t -> Rat.t
(** Of the corners: the factor times that of the curved solid. *)
