(** What the characters of a document stand for, each with its place. The text is one that Xmlm has read. *)

open Scc_base
open Scc_syntax

val attribute : Source.t -> int -> int -> Embedded.t
(** The value of an attribute, between these offsets: references decoded, line ends and tabs as spaces. *)

val content : Source.t -> int -> int -> Embedded.t
(** What stands in an element that has none in it: references decoded, marked sections as they are, comments and
    instructions left out, without the spaces at its ends. *)

val none : Source.t -> int -> Embedded.t
(** No text, at this offset. *)
