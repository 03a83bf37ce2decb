(** Colours and paints as CSS and SVG write them. *)

open Scc_exact

type colour = { rgb : int;  (** 0xRRGGBB *) alpha : Rat.t  (** from 0 to 1 *) }

type paint =
  | Nothing
  | Current  (** the value of the property [color] *)
  | Colour of colour
  | Server of string * paint option  (** a gradient by its id, and what is painted if there is none *)

val colour : string -> colour option
(** A colour: a name of CSS, [#rgb], [#rgba], [#rrggbb], [#rrggbbaa], [rgb()], [rgba()], [hsl()] or [hsla()] in
    all their notations, or [transparent]. Upper and lower case are the same. [None] for [currentColor]. Raises
    {!Svg_number.Bad} for a text that violates the format, and {!Svg_number.Unread} for other functions and
    names. *)

val paint : string -> paint
(** A paint: [none], [currentColor], a {!val-colour}, or [url(#id)] with or without what takes its place. It
    raises what {!val-colour} raises. *)

val reference : string -> string option
(** [reference text] is the id in [url(#id)], quoted or not; [None] if the text is not of this form. *)
