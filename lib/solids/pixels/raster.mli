(** Pictures as rows of pixels, from the top, each row from the left. *)

type t = {
  width : int;
  height : int;  (** in pixels, at least 1 *)
  colours : int array;  (** of each pixel red, green and blue as 0xRRGGBB *)
  alphas : Bytes.t;  (** of each pixel how opaque it is, from 0 to 255 *)
}

val max_side : int
(** 2 048 pixels: then all that is asked about places in a picture fits in native integers. *)

val max_pixels : int
(** 2{^18}, as 512 x 512 has: more takes minutes to inflate, and says no more about a shape of a few hundred
    faces. *)

val too_large : width:int -> height:int -> bool
(** Whether such a picture is refused, before memory is taken for it. *)

val create : width:int -> height:int -> t
(** Of a size that is not refused: transparent and black. *)

val colour_text : int -> string
(** ["#ff8000"]. *)
