(** Unions of convex cells that are convex. *)

val merge : tick:(unit -> unit) -> Cell.t -> Cell.t list -> Cell.t list
(** Cells without common inner points, all of them inside the box, joined until no two can be joined. Two cells
    with a common facet, corner for corner, become one if each is behind all planes of the other but that of
    the facet. That is so iff their union is convex. The order depends on the cells alone. [tick] is called for
    each pair that is tried. *)
