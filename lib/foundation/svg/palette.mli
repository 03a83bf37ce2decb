(** Colours that people who confuse some colours can tell as well. *)

val colour : int -> string
(** The colour with a number from 0 on, as SVG and CSS write it. Of middle lightness, so that a wash of it is
    pale on white and deep on black. *)

(** {1 Mixtures} *)

type rgb = float * float * float
(** Red, green and blue, from 0 to 1. *)

val body : int -> rgb
(** The colours of families of bodies, the same as on the page of [scc view]; after ten they come again. *)

val white : rgb
val black : rgb

val mix : rgb -> rgb -> float -> rgb
(** [mix a b x] is so much of b, from 0 to 1, and the rest of a. *)

val hex : rgb -> string
(** ["#4477aa"]. *)
