(** Triangulations of a polygon with holes whose vertices have heights, to which points are added. A {e chord}
    is an edge inside the polygon that has both ends on the outline: there, front and back of a solid would
    meet. Edges are flipped to have few chords, and among equally many chords to be Delaunay. Points are never
    removed. Places and heights as in {!Front}. *)

type t

val make : Outline.loop list -> t
(** The triangulation of the loops, the outer one first, without inner vertices. All heights are 0. *)

val vertices : t -> int
(** The number of vertices, those of the outline first. *)

val vertex : t -> int -> Front.corner
(** The place and the height of the vertex of a number. *)

val on_outline : t -> int -> bool
(** [on_outline t v] is true if vertex [v] is a corner of the outline. *)

val triangles : t -> int
(** The number of triangles, which are numbered from 0. A number stays in use, but its triangle may change. *)

val corners : t -> int -> int * int * int
(** The vertices of a triangle, counter-clockwise on the screen. *)

val edges : t -> (int * int) list
(** All edges, each once, those of the outline included. *)

val chords : t -> (int * int) list
(** The edges inside the polygon that have both ends on the outline. *)

val chord_count : t -> int
(** The number of {!chords}, in constant time. *)

val locate : t -> int -> int -> int option
(** [locate t x y] is a triangle that contains the place, border included; [None] if there is none. All
    triangles are tried. *)

val insert : t -> int -> Front.corner -> int list
(** [insert t k p] adds a vertex at a place in the triangle [k], which is on no edge of the outline, nor at a
    vertex (a bug otherwise). It returns the triangles that are new or have changed. *)
