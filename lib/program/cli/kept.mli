(** Stores of commands: their identity, option and messages. *)

open Scc_base
open Scc_store

val identity :
  digest:string -> parameters:(string * Scc_exact.Rat.t) list -> (string * string) list -> (string * string) list
(** The identity of a store: this build, a model with this digest and these values of parameters, and options by
    names and values ({!Store.openly}). *)

val openly : Console.t -> folder:string -> (string * string) list -> (Store.t, Diag.t list) result
(** Opens a store with an identity. When it can no longer be written, a warning (SC0103) appears at once, on
    standard error even in JSON mode. *)

val code : Diag.t list -> Scc_verdicts.Exit_code.t list
(** The exit codes for errors of a store, at the end. *)

val conclude : Console.t -> Diag.t list -> unit
(** Reports errors of a store, like its warning. *)

val option : doc:string -> string option Cmdliner.Term.t
(** The option [--store DIR]. *)
