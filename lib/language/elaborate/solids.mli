(** Solids that are computed and not listed: hulls of points, boxes, prisms and others. The names and places of
    their vertices and faces are in specs/language.md. *)

open Scc_base
open Scc_exact
open Scc_geometry
open Scc_syntax

val hull : Report.t -> Span.t -> (string * Vec.t) list -> Polyhedron.ifs option
(** The convex hull of named points. Its vertices are the points that are corners of it, in order; its faces are
    f1, f2, …. Points in one plane are SC0301, and more than 100 points SC0111. *)

val on_circle : int -> int -> Rat.t * Rat.t
(** [on_circle n k], 0 <= k < n, is an exact rational point of the unit circle. Its angle differs from k/n of a
    full turn by less than 2^-10 radians, and is exact for quarters of a turn. *)

val find : Report.t -> Ast.reference -> Family.reference -> Polyhedron.ifs option option
(** The faces of [box(a, b, c)], [prism(n, r, h)], [antiprism(n, r, h)] or [pyramid(n, r, h)], and [None] for
    any other name. It is [Some None] if the arguments do not fit, which is reported. *)

val label : Ast.reference -> Family.reference -> string option
(** The label of a predefined solid, such as ["box(1,2,3)"], in every text. It is [None] for what names none, as
    [m.box(1, 2, 3)] does: no module has predefined names. *)

val names : string list
(** The keys of these solids, such as ["box(_,_,_)"]. *)
