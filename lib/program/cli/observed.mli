(** The numbers and predicates of the option [--observe]. *)

open Scc_base
open Scc_loading

val questions :
  Console.t ->
  Loaded.t ->
  string list ->
  name:(int -> string -> string) ->
  (int -> Source.t -> Question.t -> refuse:(Code.t -> ?hint:string -> string -> ('a, Diag.t list) result) ->
   ('a, Diag.t list) result) ->
  (Loaded.t * 'a list, Diag.t list) result
(** [questions console l texts ~name meant] is the model in which the texts have their meaning, and what [meant]
    makes of each: by its place, from 0, its source, and what it asks for. [refuse code why] is the error that the
    whole text is not what is needed. [name i text] is the name of a text in messages. *)

val all : Console.t -> Loaded.t -> string list -> (Loaded.t * Scc_export.Table.observable list, Diag.t list) result
(** The observables of these texts, with the model in which they have their meaning
    ({!Scc_loading.Question.all}). *)
