(** The declarations of a text as a tree, and its parts that can be folded. *)

open Scc_base
open Scc_describe

(** A declaration with those within it. *)
type node = {
  name : string;
  kind : string;  (** as {!Declared.kind}; ["loop"] of a [for], ["import"], ["motion"] *)
  about : string;  (** a line that describes it *)
  at : Span.t;  (** all of it *)
  name_at : Span.t;
  inner : node list;
}

val of_text : Reading.t -> node list
(** The tree of a text, in its order. *)

(** A part that can be folded. *)
type fold = { from : int; upto : int;  (** offsets *) comment : bool }

val folds : Reading.t -> fold list
(** The brackets, comments and declarations of a text, whether or not they are on several lines. Comments that
    follow each other, each on a line, are one part. *)
