(** A document as a whole: its declarations, folds and layout. *)

open Scc_json

val symbol_kind : string -> int
(** The number that the protocol has for a kind of declarations ({!Scc_assist.Outline.node}). *)

val symbols : Session.t -> Json.t -> Json.t
(** The declarations as a tree. *)

val folds : Session.t -> Json.t -> Json.t
(** The parts that can be folded. *)

val layout : Session.t -> Json.t -> Json.t
(** The edits to canonical layout; none if the text has errors. *)

val layout_within : Session.t -> Json.t -> Json.t
(** The edits to canonical layout of the declarations that a range touches ({!Scc_assist.Formatting}). *)
