(** Colours and paints as CSS and SVG write them. *)

open Scc_exact

type colour = { rgb : int;  (** 0xRRGGBB *) alpha : Rat.t  (** from 0 to 1 *) }

type paint =
  | Nothing
  | Current  (** the value of the property [color] *)
  | Colour of colour
  | Server of string * paint option  (** a gradient by its id, and what is painted if there is none *)

val paint : string -> paint
(** [paint text] is what the text of a property says: [none], [currentColor], [url(#id)] with or without what
    takes its place, or a colour. A colour is a name of CSS, [#rgb], [#rgba], [#rrggbb], [#rrggbbaa], [rgb()],
    [rgba()], [hsl()] or [hsla()] in all their notations, [hwb()], [lab()], [lch()], [oklab()], [oklch()],
    [color()] in [srgb], [srgb-linear] or [display-p3], or [transparent]. What [icc-color()] says behind a colour
    does not count. Upper and lower case are the same. Raises {!Svg_number.Bad} for a text that violates the
    format, and {!Svg_number.Unread} for other functions and names. *)

val reference : string -> string option
(** [reference text] is the id in [url(#id)], quoted or not; [None] if the text is not of this form. *)

val is_unknown : string -> bool
(** [is_unknown word] is true for a word, in small letters, that is no paint and no colour of CSS, also none
    that is not read. *)
