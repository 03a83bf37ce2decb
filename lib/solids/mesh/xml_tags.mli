(** The tags of an XML text, each with its place. *)

open Scc_base

type attribute = { key : Text.word; value : int * int  (** where the value begins and ends *) }

type tag = {
  name : Text.word;  (** with a slash before it, if the tag ends an element *)
  attributes : attribute list;  (** in the order of the file *)
  closed : bool;  (** the element ends with this tag *)
}

val characters : string
(** The name of what {!tags} gives for characters between tags that are not blank: no element has it. *)

val tags : path:string -> string -> (tag list, Diag.t) result
(** All tags in order, without comments, instructions, declarations and CDATA. A document type with declarations of
    its own is refused, and so is what has no end (SC0320). *)

val value : path:string -> string -> attribute -> (string, Diag.t) result
(** [value ~path text attribute] is the value of an attribute of this text, with characters in the place of
    references. A reference that XML does not define is SC0320. *)

val words : path:string -> string -> attribute -> (Text.word list, Diag.t) result
(** [words ~path text attribute] are the words of {!value}, separated by blanks, line ends and commas. *)

val well_formed : path:string -> string -> tag list -> (unit, Scc_base.Diag.t) result
(** [well_formed ~path text tags] is an error (SC0320) if an attribute is there twice in a tag, or has a value
    that is none in XML: with a [<], or with a reference that XML does not know. *)
