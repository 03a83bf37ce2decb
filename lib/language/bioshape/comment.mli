(** Comments, between the language and XML.

    In a comment of XML no two hyphens meet, and none stands at its end. Written there, a backslash keeps them
    apart, one more than were between them before; read, it is taken away, so that a comment comes back as it
    was. What no character of XML is becomes a space. *)

open Scc_syntax

val written : Trivia.t -> Trivia.t
(** A comment of the language, as one of XML. *)

val read : string -> Trivia.kind * string
(** What stands between the marks of a comment of XML, as one of the language: to the end of the line if it is on
    one line. What would be a mark there is taken apart by a space. *)
