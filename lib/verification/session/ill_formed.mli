(** Models with ranges that are not well-formed for some of their values. *)

open Scc_base
open Scc_verify
open Scc_loading

val diagnostics : Loaded.t -> Zone_check.fault -> Diag.t list
(** The diagnostics of a fault (SC0403, SC0401), with the values of parameters. Their places in the text are
    those at which the model with just these values is refused. *)
