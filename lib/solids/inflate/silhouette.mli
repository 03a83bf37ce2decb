(** Which pixels of a picture belong to the drawn shape. *)

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

(** A set of pixels that hang together by their edges. *)
type piece = { pixels : int; at : int * int  (** column and row in the picture of its first pixel, from 0 *) }

type fault =
  | Empty  (** no pixel is of the shape *)
  | Several of piece list  (** the largest first *)
  | No_such_piece of piece list

val find : ?background:int -> ?piece:int -> Raster.t -> (t, fault) result
(** A pixel is of the shape when it is at least half opaque and, in a picture without transparency or with a given
    background, when its red, green or blue is at least half of the whole range away from that of the background,
    which is white if not given. Pixels that only touch at a corner do not hang together. [piece] chooses one of
    several, from 1, by size. *)

val is_inside : t -> int -> int -> bool
(** Also of places beyond the rectangle. *)

val colour : t -> int -> int
(** Of the pixel of an index, which is of the shape. *)

val colours : t -> (int * int) list
(** The colours of the shape, each with the number of its pixels, the most frequent first. *)

val depth : t -> int
(** The squared distance from the centre of some pixel of the shape to the nearest centre of one that is not, at
    its greatest. *)
