(** Models with ranges that are not well-formed for some of their values. *)

open Scc_base
open Scc_verify

val diagnostics : Loaded.t -> Zone_check.fault -> Diag.t list
(** What is wrong (SC0403, SC0401), for which values, and at the places in the text where the model of just these
    values is refused. *)
