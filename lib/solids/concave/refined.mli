(** Convex parts, cut further until each of their features shows at most one feature of the drawn solid. *)

open Scc_exact
open Scc_geometry

val solid : Vec.t list -> Polyhedron.t
(** The convex hull of points that are not in one plane (a bug otherwise). Its names have no meaning. *)

val of_cell : Scc_decompose.Cell.t -> Polyhedron.t
(** The cell as {!solid} of its corners would be, from its facets. *)

val parts :
  tick:(left:int -> unit) -> names:bool -> Shown.t -> Drawn.t -> limit:int -> Polyhedron.t list ->
  (Polyhedron.t * (Feature.t * Drawn.feature list) list) list option
(** Convex parts of the solid, each with the features that its own features show. Without [names], these are faces
    alone. With [names], a part is cut in two if a face shows pieces of two regions, or an edge continues from a
    border into a region. The cut is along the plane of a face of the solid that divides the feature. [None] if
    there would be more than [limit] parts. [tick] is called for each part, with the number of parts left. *)
