(** The front of an inflated shape: a height over each point of the plane.

    Places are in eighths of a pixel, [x] to the right and [y] downward, the centre of the pixel (i, j) of the
    rectangle at (8i, 8j). Heights are in quanta ({!Relief}). Between four centres of pixels the surface
    consists of triangles. Its outline runs half-way between the centre of each pixel of the shape and those of
    its neighbours outside (marching squares). The height is 0 on the outline and beyond. Pixels of the shape
    that only touch at a corner are separate. Four centres within the shape are divided along the higher
    diagonal, which is the same for the mirror image. When both diagonals are equally high, the four are in one
    plane. *)

type corner = { x : int; y : int; z : int }

val unit : int
(** The distance between centres of neighbouring pixels: 8. *)

val triangles : Relief.t -> int -> int -> (corner * corner * corner) list
(** [triangles r i j] are the triangles between the centres of the pixels (i, j) and (i + 1, j + 1). Corners
    are in the order that is counter-clockwise where [y] goes upward. At least one corner of each is higher
    than 0. *)

val height : Relief.t -> int -> int -> int * int
(** [height r x y] is the height at a place, which need not be a centre, in quanta: numerator and denominator >
    0. *)

val cross : int -> int -> int -> int -> int -> int -> int
(** [cross ax ay bx by cx cy] is twice the signed area of the triangle. It is negative for the order of
    {!triangles}, as [y] goes downward. *)
