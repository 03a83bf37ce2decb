(** The models of a session, as handles. *)

open Scc_base
open Scc_session

type loaded = { model : Loaded.t; network : Network_at.t }

type store

val store : Quotas.t -> read_file:Loaded.reader -> store
(** [read_file] is asked for files that a model names, and that are not part of the request. *)

val no_files : Loaded.reader
(** For who has none. *)

val model : store -> loaded Read.reader
(** Of a handle. *)

val choices : Read.params -> int array
(** The param [path]. *)

val path : Read.params -> Network_at.t -> Network_at.place
(** Where it leads. *)

val forget : store -> unit
(** What was worked out of the models, and may have been left half made. *)

val load : store -> Read.params -> Reply.t
val read : store -> more:string list -> Read.params -> Loaded.t * (string -> Source.t option)
(** The model of a request that gives all of it, as [model.load] does, and has no other members but [more]; and
    its texts by name. Its parameters may have ranges, and its bonds may be released at any time. *)

val release : store -> Read.params -> Reply.t

(** {1 With a formula} *)

val with_formula :
  store ->
  handle:string ->
  formula:string ->
  Question.form ->
  (loaded, Diag.t list) result
(** The model with the formula, in this form, as its last check. Those asked for lately are kept. *)

val sources : store -> string -> formula:string -> string -> Source.t option
(** The texts of the model of a handle, and of a formula, by name. *)
