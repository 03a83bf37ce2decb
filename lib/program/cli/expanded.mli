(** How the states of an exploration are expanded: by how many processes, and whether it is kept. *)

open Scc_base
open Scc_session

type t

val openly :
  Console.t -> jobs:int option -> store:string option -> memory:int -> (string * string) list -> Loaded.t ->
  (t, Diag.t list) result
(** [memory], in words: of what there may be; with a store, tables go to its folder when they take a quarter of it.
    With what the options say of what is explored, by names: a store is of these, of the model and of this
    version. *)

val expanding : t -> about:string -> Scc_state_space.State_graph.expanding

val compacting : t -> about:string -> Scc_state_space.State_fingerprints.expanding

val guard : t -> (unit -> ('a, Diag.t list) result) -> ('a, Diag.t list) result
(** Of something that explores: also the error that a store does not fit (SC0912). *)

val no_sets : ('a, Diag.t list) result
(** The error that a store keeps no exploration by sets of states (SC0901). *)

val close : t -> Diag.t list
(** What went wrong with the store. *)
