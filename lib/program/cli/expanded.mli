(** How the states of an exploration are expanded: by how many processes, and with or without a store. *)

open Scc_base
open Scc_loading

(** The processes and the store of an exploration. *)
type t

val openly :
  Console.t -> jobs:int option -> store:string option -> memory:int -> (string * string) list -> Loaded.t ->
  (t, Diag.t list) result
(** [openly c ~jobs ~store ~memory options l] opens the store in a folder, if one is given. [memory] is the
    limit in words; with a store, tables move to its folder when they take a quarter of it. [options] are the
    names and values of the options that affect the exploration. A store belongs to these, to the model and to
    this build. *)

val expanding : t -> about:string -> Scc_state_space.State_graph.expanding
(** How states are expanded. [about] is the name of the exploration in the store. *)

val compacting : t -> about:string -> Scc_state_space.State_fingerprints.expanding
(** How states are expanded under hash compaction. [about] is the name of the exploration in the store. *)

val guard : t -> (unit -> ('a, Diag.t list) result) -> ('a, Diag.t list) result
(** Calls a function that explores. A store that does not fit the exploration is an error (SC0912). *)

val no_sets : ('a, Diag.t list) result
(** The error that a store does not keep an exploration by sets of states (SC0901). *)

val close : t -> Diag.t list
(** Closes the store, and returns its error if writing to it failed. *)
