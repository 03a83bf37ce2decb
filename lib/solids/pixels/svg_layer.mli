(** What is painted over what: exact colours and opacities of pixels, by the operator "over" of Porter and Duff
    (1984), which SVG takes for paints and for groups. *)

open Scc_exact

type source
(** A paint of one colour. *)

val source : ?upper:Rat.t -> rgb:int -> Rat.t -> source option
(** [source ~rgb alpha] is a paint of the colour 0xRRGGBB, which is [alpha] opaque, from 0 to 1. With [upper], it
    is from [alpha] to [upper] opaque. [None] if nothing of it is seen. *)

type t
(** A picture that is being painted. *)

val whole : int -> t
(** [whole n] is a transparent layer of [n] pixels. *)

val above : t -> t
(** A transparent layer to be put onto this one. It takes memory for the pixels that are painted. *)

val painter : cost:(int -> unit) -> t -> source -> int -> unit
(** [painter ~cost layer source] paints the pixel of an index. Pixels that were painted alike are computed once
    for each [painter]; [cost] is called with the length of their numbers. Raises {!Svg_number.Unread} if these
    get too long. *)

val put : cost:(int -> unit) -> t -> onto:t -> Rat.t -> unit
(** [put ~cost layer ~onto alpha] paints a layer over another one as a group of this opacity. Raises like
    {!painter}. *)

type seen =
  | Transparent  (** less than half opaque *)
  | Seen of int  (** at least half opaque, with its colour 0xRRGGBB, rounded to levels *)
  | Open  (** it depends on opacities that are known only within bounds *)

val seen : t -> int -> seen
(** [seen layer k] is how the pixel of the index [k] is seen. *)
