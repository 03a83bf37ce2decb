(** Solids that are made and not listed: hulls of points, boxes, prisms and their like. What their vertices and
    faces
    are called, and where they are, is told in specs/language.md. *)

open Scc_base
open Scc_exact
open Scc_geometry
open Scc_syntax

val hull : Report.t -> Span.t -> (string * Vec.t) list -> Polyhedron.ifs option
(** The convex hull of named points. Its vertices are those that are corners of it, in order, its faces f1, f2,
    …. SC0301
    where all are in one plane, SC0111 for more than a hundred. *)

val on_circle : int -> int -> Rat.t * Rat.t
(** [on_circle n k], 0 <= k < n: a rational point of the unit circle, exactly, at an angle that differs from
    k/n of a full
    turn by less than 2^-10 radians, and not at all for quarters of a turn. *)

val find : Report.t -> Ast.reference -> Family.reference -> Polyhedron.ifs option option
(** [box(a, b, c)], [prism(n, r, h)], [antiprism(n, r, h)] and [pyramid(n, r, h)]: [None] for any other name,
    [Some None] where the arguments do not fit, which is reported. *)

val names : string list
(** Of these, with blanks for their arguments. *)
