(** Convex cells joined while what comes out is convex. *)

val merge : tick:(unit -> unit) -> Cell.t -> Cell.t list -> Cell.t list
(** Cells without common inner points, all of them inside the box. Two with a facet in common, corner for
    corner, become one cell if each is behind all planes of the other but that of the facet: that is so iff
    their union is convex. In an order that depends on the cells alone. *)
