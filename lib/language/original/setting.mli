(** How curved solids become polyhedra in a model: the declaration [curved inscribed 1/20]. *)

open Scc_exact
open Scc_syntax

(** The side and the distance of the polyhedra, or none. *)
type t

val none : t
(** No such declaration. *)

val rough : t
(** The coarsest setting, for a declaration with an error. So the model has no further errors because of it. *)

val read : Plain.t -> Ast.name -> Ast.expr -> t
(** [read plain word e] is the setting of the side [word] and the distance [e], a fraction of the radius. Raises
    {!Fault.Found}: SC0362 if [e] is no plain number, SC0365 if it is not between {!Scc_mesh.Curved.least} and
    1/2. *)

val notes : t -> string list
(** Sentences for the kinds of curved solids used so far: how many corners their polyhedra have, and how near
    they are. *)

(** A curved solid with its polyhedron and its lengths. *)
type curved =
  | Sphere of Scc_mesh.Curved.t * Ast.expr
  | Cylinder of Scc_mesh.Curved.t * Ast.expr * Ast.expr  (** radius and height *)
  | Cone of Scc_mesh.Curved.t * Ast.expr * Ast.expr

val curved : t -> Ast.reference -> curved option
(** The curved solid of [sphere(r)], [cylinder(r, h)] or [cone(r, h)], and [None] for other names. Raises
    {!Fault.Found}: SC0365 if the model has no setting, SC0206 for other arguments. *)

val ball_name : int -> string
(** [ball_name n] is the name of the shape {!Scc_mesh.Curved.ball}[ n], which replaces the ball of radius 1. *)

val solid : Scc_base.Span.t -> curved -> Ast.solid_kind
(** The solid in the language: the shape {!ball_name} scaled, a [prism] or a [pyramid]. Its radius has the
    factor of a circumscribed polyhedron. *)

val radius : Scc_mesh.Curved.t -> Rat.t -> Rat.t
(** [radius c r] is the distance of the corners from the axis or the centre: the factor of [c] times [r]. *)
