(** Documents of XML as elements with their places. Xmlm reads them, and says what is well-formed; where things
    stand is found by going once more over what it has read.

    Refused: what is not UTF-8 (SC0102), what is not well-formed (SC0350), document types, entities but the five
    of XML itself, and declarations of another encoding (SC0351), elements nested deeper than {!max_nesting}
    (SC0111). Nothing is fetched and nothing expanded, so that no document is larger in memory than its text
    times a constant. *)

open Scc_base
open Scc_syntax

type element = {
  tag : string;  (** without its prefix *)
  at : Span.t;  (** of the start tag *)
  whole : Span.t;  (** from there to the end of its end tag *)
  close : int;  (** offset of the end tag; of the end of the tag, if it is one for both *)
  attributes : (string * (Span.t * Embedded.t)) list;
  (** with the places of their names, in the order of the text; those of the schema's instances are left out *)
  children : element list;
  text : Embedded.t;  (** what stands in an element without elements in it *)
}

type t = {
  root : element;  (** with its children, or without those that [each] took *)
  trivia : Trivia.t list;  (** the comments, as those of the language, and empty lines *)
}

val max_nesting : int
(** 2 010: a choice within a choice takes two elements, so that what the language can nest can be written. *)

val max_attributes : int
(** Of one element (SC0352): 100. *)

val read : namespace:string -> each:(element -> unit) -> Source.t -> (t, Diag.t) result
(** [each] is given the children of the root, one by one, with what is in them; they are not kept. An element or
    attribute that is not of the namespace is SC0352. [each] may end the reading by {!Stop}. *)

exception Stop
(** Raised by [each], and passed on. *)
