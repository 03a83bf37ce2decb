(** The numbers and predicates that [--observe] asks for. *)

open Scc_base
open Scc_session

val all : Console.t -> Loaded.t -> string list -> (Loaded.t * Scc_export.Table.observable list, Diag.t list) result
(** With the model in which they have their meaning ({!Scc_session.Question.all}). *)
