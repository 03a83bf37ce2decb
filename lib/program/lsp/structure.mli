(** A document as a whole: its declarations, folds, colours and layout. *)

open Scc_json

val symbols : Session.t -> Json.t -> Json.t
(** The declarations as a tree. *)

val folds : Session.t -> Json.t -> Json.t
(** The parts that can be folded. *)

val legend : Json.t
(** The kinds and marks of words in {!colours}. *)

val colours : Session.t -> Json.t -> Json.t
(** What each word is, in the encoding of the protocol. *)

val colours_within : Session.t -> Json.t -> Json.t
(** What each word of a range is, in the encoding of the protocol. *)

val layout : Session.t -> Json.t -> Json.t
(** The edits to canonical layout; none if the text has errors. *)
