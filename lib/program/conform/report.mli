(** The result of {!Verdict}, as text and as JSON ([specs/schema/conform.schema.json]). *)

open Scc_exact
open Scc_calculus
open Scc_json

(** A result with its model and trace. *)
type t = {
  file : string;  (** of the model *)
  loaded : Scc_loading.Loaded.t;
  trace : Recorded.t;
  tolerance : Rat.t;
  answer : Verdict.answer;
}

val text : t -> string
(** The result as lines of text. *)

val json : t -> exit:int -> diagnostics:Json.t list -> Json.t
(** The result as a document. *)

val about : Rat.t -> Json.t
(** A number as [{"exact": "5/4", "about": "1.25"}]; the second member is for readers. *)

val event_json : Recorded.event -> Json.t
(** A recorded event as an object. *)

val source_line : Recorded.item -> string
(** The place of an item, such as ["line 5, time 2.1"]. *)

val reason : Model.t -> Trace_search.reason -> string
(** Why a search ended without a result. *)
