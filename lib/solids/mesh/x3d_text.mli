(** The text of a file in XML, whose words have places that are counted from any number on. Faults raise
    {!Scene.Refused}, at the place in the file. *)

type t = {
  path : string;
  text : string;
  first : int;  (** the place of its first byte *)
}

val tags : t -> Xml_tags.tag list
(** Its tags, as {!Xml_tags.tags} has them; they are {!Xml_tags.well_formed}. *)

val value : t -> Xml_tags.attribute -> string
(** The value of an attribute of these tags. *)

val words : t -> Xml_tags.attribute -> Text.word list
(** The words of the value. *)

(** {1 Attributes} *)

val attribute : Xml_tags.tag -> string -> Xml_tags.attribute option
(** The attribute of that name. *)

val value_of : t -> Xml_tags.tag -> string -> string option
(** Its value. *)

val needed : t -> Xml_tags.tag -> string -> string
(** Its value; without that the tag is refused. *)

val needed_word : t -> Xml_tags.tag -> string -> Text.word
(** That, at its place. *)

(** {1 Interfaces of prototypes} *)

val inner_field : t -> Xml_tags.tag * Xml_tags.tag list -> Scene.declared * bool
(** What a [field] of a [ProtoInterface] declares, with the tags in it, and whether that is an event. An event with
    a value is refused. *)

val outer_field : t -> Xml_tags.tag * Xml_tags.tag list -> Scene.declared
(** What a [field] of an [ExternProtoDeclare] declares. A value in it is refused. *)
