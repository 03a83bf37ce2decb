(** Triangulations of a polygon with holes whose corners have heights, to which points are added: triangles that
    are joined along edges, Delaunay as far as one thing that comes first allows. That is that few edges other
    than those of the outline have both ends on the outline: on such a {e chord} the front and the back of a
    solid would meet. Points are added once and never go. Places and heights as in {!Front}. *)

type t

val make : Outline.loop list -> t
(** Of the corners of the outline, whose height is 0. *)

val vertices : t -> int
val vertex : t -> int -> Front.corner

val on_outline : t -> int -> bool
(** Whether the vertex is a corner of the outline. *)

val triangles : t -> int
(** They are numbered from 0; numbers stay in use, but not for the same triangle. *)

val corners : t -> int -> int * int * int
(** Vertices of a triangle, counter-clockwise on the screen. *)

val edges : t -> (int * int) list
(** Each once, those of the outline included. *)

val chords : t -> (int * int) list
val chord_count : t -> int

val locate : t -> int -> int -> int option
(** A triangle that has the place in it or on its edges, by looking at all. *)

val insert : t -> int -> Front.corner -> int list
(** [insert t k p] adds a vertex at a place in the triangle [k], which is on no edge of the outline, nor at a
    vertex (a bug otherwise). The triangles that are new or have changed. *)
