(** The visible parts of faces and edges. All is exact: integers decide where a face is in front of another one,
    which is where its depth is greater. Floats only select candidates. Solids may touch, and they may even
    cross. If two faces in one plane overlap, the first of them is visible. *)

open Scc_exact

(** A view with a grid of its faces, and the visible pieces found so far. *)
type t

val make : ?glass:(int -> bool) -> View.t -> t
(** Prepares a view. Visible pieces are found when they are needed, and cached. Solids whose index satisfies
    [glass] (none by default) are of glass: they hide each other and nothing else. *)

val view : t -> View.t
(** The view itself. *)

val is_glass : t -> int -> bool
(** [is_glass t body] is true if the solid is of glass. *)

val pieces : t -> int -> Convex.t list
(** The visible part of a face of the view, in disjoint convex pieces. *)

val hiders : t -> int -> int list
(** The faces that hide a part of a face of the view. *)

val all_pieces : t -> Convex.t list array
(** The visible parts of all faces, as by {!pieces}. *)

val segments : t -> View.edge -> (Ivec.t * Ivec.t) list
(** The visible parts of an edge, in order: those along which a face of it is visible. *)

val uncovered : t -> Ivec.t * Rat.t -> Ivec.t * Rat.t -> (Ivec.t * Ivec.t) list
(** The parts of a segment without a face in front of them, except of glass. Both ends are points of the picture
    with their depths. Sides of faces hide nothing. *)

val shows : t -> Ivec.t -> depth:Rat.t -> bool
(** [shows t p ~depth] is true if no face, except of glass, is in front of the point [p] of the picture at that
    depth. *)

val front : t -> Ivec.t -> int option
(** The face that is visible at a point of the picture, which must be on no side of a face. Faces of glass are
    left out. *)
