(** Documents of XML as elements with their places. Xmlm reads them and checks that they are well-formed. A
    second pass over the text finds the places.

    Errors: a text that is not UTF-8 (SC0102) or not well-formed (SC0350), and elements nested deeper than
    2 010 levels (SC0111): a choice within a choice takes two, so this is enough for all that the language can
    nest. Document types, entities except the five of XML, and declarations of another encoding are refused
    (SC0351).

    Nothing is fetched and nothing is expanded. So a document in memory is at most a constant factor larger than
    its text. *)

open Scc_base
open Scc_syntax

type element = {
  tag : string;  (** without its prefix *)
  at : Span.t;  (** of the start tag *)
  whole : Span.t;  (** from there to the end of its end tag *)
  attributes : (string * (Span.t * Embedded.t)) list;
  (** with the places of their names, in the order of the text; [xmlns] and names with a prefix are left out *)
  children : element list;
  text : Embedded.t;  (** the text of an element without elements in it *)
}

(** A whole document. *)
type t = {
  root : element;  (** without children: {!read} has passed them to [each] *)
  trivia : Trivia.t list;  (** the comments, as comments of the language, and empty lines *)
}

val read : namespace:string -> each:(element -> unit) -> Source.t -> (t, Diag.t) result
(** Reads a document. [each] receives the children of the root one by one, with all that they contain; they are
    not kept. An element or attribute of another namespace is SC0352, and so is an element with more than 100
    attributes. [each] may end the reading by {!Stop}. *)

exception Stop
(** Ends the reading: [each] may raise it, and {!read} does not catch it. *)
