(** Pictures as rows of pixels, from the top, each row from the left. *)

type t = {
  width : int;
  height : int;  (** in pixels, at least 1 *)
  colours : int array;  (** of each pixel red, green and blue as 0xRRGGBB *)
  alphas : Bytes.t;  (** of each pixel how opaque it is, from 0 to 255 *)
}

val max_side : int
(** The greatest width and height, 2 048 pixels: all computations with places in a picture then fit in native
    integers. *)

val max_pixels : int
(** The greatest number of pixels, 2{^18}, as 512 x 512 has. More pixels take minutes to inflate, without a
    visible effect on a shape of a few hundred faces. *)

val too_large : width:int -> height:int -> bool
(** [too_large ~width ~height] is true if a picture of this size is refused, before memory is allocated for
    it. *)

val create : width:int -> height:int -> t
(** A transparent and black picture of a size that is not {!too_large}. *)

val colour_text : int -> string
(** A colour 0xRRGGBB as a text: ["#ff8000"]. *)
