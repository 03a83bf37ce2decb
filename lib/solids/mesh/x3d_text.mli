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
