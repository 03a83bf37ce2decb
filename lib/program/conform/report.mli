(** What {!Verdict} found, for people and as JSON ([specs/schema/conform.schema.json]). *)

open Scc_exact
open Scc_calculus
open Scc_exchange

type t = {
  file : string;  (** of the model *)
  loaded : Scc_session.Loaded.t;
  trace : Recorded.t;
  tolerance : Rat.t;
  answer : Verdict.answer;
}

val text : t -> string

val json : t -> exit:int -> diagnostics:Json.t list -> Json.t

val about : Rat.t -> Json.t
(** [{"exact": "5/4", "about": "1.25"}]: the second is for people. *)

val event_json : Recorded.event -> Json.t
val source_line : Recorded.item -> string
(** ["line 5, time 2.1"]. *)

val reason : Model.t -> Search.reason -> string
