(** The characters that a document of XML stands for, each with its place. Xmlm must have read the document
    before. *)

open Scc_base
open Scc_syntax

val attribute : Source.t -> int -> int -> Embedded.t
(** [attribute source start stop] is the value of an attribute between two offsets. References are decoded; line
    ends and tabs become spaces. *)

val content : Source.t -> int -> int -> Embedded.t
(** [content source start stop] is the text of an element without elements in it. References are decoded, marked
    sections are kept as they are, and comments and instructions are left out. Spaces at the ends are
    removed. *)

val none : Source.t -> int -> Embedded.t
(** [none source at] is the empty text at an offset. *)
