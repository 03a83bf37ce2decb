(** The pixels of a picture that belong to the drawn shape. *)

open Scc_pixels

(** A rectangle of pixels with a border of one pixel around it, none of which is of the shape. Places are columns
    and rows in it, from 0; the pixel at column [x] and row [y] has the index [y * width + x]. *)
type t = {
  width : int;
  height : int;
  inside : Bytes.t;  (** ['\001'] where a pixel is of the shape *)
  size : int;  (** how many are *)
  left : int;
  top : int;  (** the place in the picture of the pixel (0, 0), which may be -1 *)
  picture : Raster.t;
}

(** A set of pixels that are connected by their edges. *)
type piece = { pixels : int; at : int * int  (** column and row in the picture of its first pixel, from 0 *) }

type fault =
  | Empty  (** no pixel is of the shape *)
  | Several of piece list  (** the largest first *)
  | No_such_piece of piece list

val find : ?background:int -> ?piece:int -> Raster.t -> (t, fault) result
(** [find picture] is the shape that is drawn. A pixel belongs to it if it is at least half opaque. In a
    picture without transparency or with a given background, its red, green or blue must also differ enough
    from the background: by half of the range at least. The background is white if it is not given. Pixels that
    only touch at a corner are not connected. If there are several pieces, [piece] chooses one, from 1, by
    size. *)

val find_all : ?background:int -> Raster.t -> (t * t list, fault) result
(** [find_all picture] is the shape of all pieces together, which need not be connected, and the pieces, the
    largest first. Pixels belong to it as in {!find}. *)

val surrounded : t -> margin:int -> t
(** [surrounded t ~margin] is the shape of all pixels of the rectangle of [t] and of a frame of [margin] more
    pixels around it, but for the border that no shape has. Its pixels may be outside of the picture. *)

val is_inside : t -> int -> int -> bool
(** [is_inside t x y] is true if the pixel at column x and row y is in the shape. Places beyond the rectangle
    are not. *)

val colour : t -> int -> int
(** [colour t i] is the colour, 0xRRGGBB, of the pixel with index [i], which is in the shape. *)

val colours : t -> (int * int) list
(** The colours of the shape, each with the number of its pixels, the most frequent first. *)

val depth : t -> int
(** The greatest squared distance, in pixels, from the centre of a pixel of the shape to the nearest centre of
    a pixel outside. *)
