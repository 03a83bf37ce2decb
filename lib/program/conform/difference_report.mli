(** The result of {!Difference}, as text and as JSON ([specs/schema/diff.schema.json]). *)

open Scc_exact
open Scc_json

val text : Recorded.t -> Recorded.t -> Difference.t option -> string
(** The result as lines of text. *)

val json : Recorded.t -> Recorded.t -> tolerance:Rat.t -> exit:int -> Difference.t option -> Json.t
(** The result as a document. *)
