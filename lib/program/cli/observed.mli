(** The numbers and predicates of the option [--observe]. *)

open Scc_base
open Scc_loading

val all : Console.t -> Loaded.t -> string list -> (Loaded.t * Scc_export.Table.observable list, Diag.t list) result
(** The observables of these texts, with the model in which they have their meaning
    ({!Scc_loading.Question.all}). *)
