(** Colours that people with colour blindness can distinguish as well. *)

val colour : int -> string
(** [colour i] is the colour with number [i >= 0], in the notation of SVG and CSS. Its lightness is medium, so that
    a transparent wash of it is pale on white and deep on black. *)

(** {1 Mixtures} *)

type rgb = float * float * float
(** Red, green and blue, from 0 to 1. *)

val body : int -> rgb
(** [body i] is the colour of the family of bodies with number [i >= 0], as on the page of [scc view]. Ten colours
    repeat cyclically. *)

val white : rgb
(** White: (1, 1, 1). *)

val black : rgb
(** Black: (0, 0, 0). *)

val mix : rgb -> rgb -> float -> rgb
(** [mix a b x] is the mixture of the share [x] of [b], from 0 to 1, and the share [1 - x] of [a]. *)

val hex : rgb -> string
(** [hex c] is the colour in the notation of CSS, such as ["#4477aa"]. Components are clamped to 0 .. 1. *)
