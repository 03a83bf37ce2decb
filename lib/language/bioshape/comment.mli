(** Comments, between the language and XML.

    A comment of XML has no two hyphens in a row and none at its end. When it is written, a backslash separates
    them, one more than were between them before. When it is read, one is removed, so a comment comes back as it
    was. A character that XML does not have becomes a space. *)

open Scc_syntax

val written : Trivia.t -> Trivia.t
(** A comment of the language as a comment of XML. *)

val read : string -> Trivia.kind * string
(** The text inside a comment of XML as a comment of the language. A comment on one line becomes a line comment.
    Marks of comments inside are separated by a space. *)
