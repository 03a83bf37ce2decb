(** The properties of an element of SVG, from its attributes and its style. *)

val of_element :
  valid:(string -> string -> bool) ->
  string -> (string * string) list -> sheet:Css.declaration list -> (string * string) list
(** [of_element ~valid name attributes ~sheet] are the properties that are read, each with its value, in the
    order in which later ones count more: of attributes, of style sheets ([sheet], {!Css.declared}), of the
    style, of what is important in these. Names are in small letters, and so are words of values, but not what
    is in brackets or quotes. The properties [transform] and [transform-origin] of the style are called [css
    transform] and [css transform-origin], as their values are written differently. Attributes and properties
    that {!Svg_table} refuses raise {!Svg_number.Unread}. [valid] is as for {!Css.declarations}. *)
