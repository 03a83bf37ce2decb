(** The models of a session, by handle. *)

open Scc_base
open Scc_loading

(** A model with the states that were visited lately. *)
type loaded = { model : Loaded.t; network : Network_at.t }

(** The models of a session, with caches. *)
type store

val store : Quotas.t -> read_file:Loaded.reader -> store
(** No models yet. [read_file] reads files that a model names and that are not part of the request. *)

val no_files : Loaded.reader
(** A reader without files: every file is an error. *)

val handle : string Read.member
(** The param [model]: a handle. *)

val model : store -> Read.params -> loaded
(** The model of the param {!handle}. *)

val along : int list Read.member
(** The param [path]. *)

val choices : Read.params -> int array
(** The param [path], or the empty path. *)

val path : Read.params -> Network_at.t -> Network_at.place
(** The end of the param [path]. *)

val forget : store -> unit
(** Empties the caches of all models, which may be incomplete. *)

val word_or_seed : string -> simple:'a -> random:(int64 -> 'a) -> 'a Read.reader
(** [word_or_seed word ~simple ~random] reads the word as [simple], and the seed of random choices as [random]. *)

val load : store Method.t
(** The method [model.load]. *)

val members : Scc_json.Json_schema.member list
(** The params that make a model: its text, files and parameters. *)

val read :
  store -> params:Scc_json.Json_schema.member list -> Read.params -> Loaded.t * (string -> Source.t option)
(** The model of a request that contains all of it, in {!members} and no other members than [params], with its
    texts by name. Its parameters may have ranges, and its bonds may be released at any time. *)

val release : store Method.t
(** The method [model.release]. *)

(** {1 With a formula} *)

val with_formula :
  store ->
  handle:string ->
  formula:string ->
  Question.form ->
  (loaded, Diag.t list) result
(** The model with the formula, in this form, as its last check. The last 8 results are cached. *)

val sources : store -> string -> formula:string -> string -> Source.t option
(** The texts of the model of a handle and of a formula, by name. *)
