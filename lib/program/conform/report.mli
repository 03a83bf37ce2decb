(** The result of {!Verdict}, and the result as text. *)

open Scc_exact
open Scc_calculus

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

val source_line : Recorded.item -> string
(** The place of an item, such as ["line 5, time 2.1"]. *)

val reason : Model.t -> Trace_search.reason -> string
(** Why a search ended without a result. *)
