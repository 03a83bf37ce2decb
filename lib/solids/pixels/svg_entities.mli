(** Entities that a drawing declares in its document type, as some programs write them for namespaces. *)

type t

val of_text : string -> t option
(** [of_text text] are the entities of the document type of an XML file, at most a thousand. [None] if it declares
    something else, an entity in another file, or one whose value has markup or a reference in it. *)

val meaning : t -> string -> string option
(** [meaning t name] is the value of an entity. Raises {!Svg_number.Bad} if all values together get longer than ten
    million bytes: an entity may be used again and again. *)
