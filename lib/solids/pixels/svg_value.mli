(** The values of attributes, whether anything is painted by them or not: malformed ones are refused. *)

val check : Svg_tree.node -> unit
(** [check node] raises {!Svg_number.Bad} if an attribute that says where something is, or how a gradient, a clip
    path or a viewport takes its place, has a value that violates its format. *)

val is_length : string -> bool
(** [is_length text] is true of a number with a unit of CSS, also with one that is not read, or with none. *)
